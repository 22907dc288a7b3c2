// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpImageSearch.h"

#include "search/vpHundredths.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// The sizes that are believed by default, of the image's height.
const double mostOfHeight = 0.9;
const double leastOfHeight = 0.05;
const double leastSize = 24.; // Pixels: smaller objects have too few edges to tell.
const double mostHeights = 4.;
// What is scanned for.
const double sizeStep = 1.25;
const unsigned int scannedLevel = 2; // Of the sphere.
const int turns = 24;                // In the image.
const double cellsPerRadius = 6.;
const double clutter = 1.;
const std::size_t placesOfView = 3;
const std::size_t placesOfSize = 1000;
const double scannedColors = 0.3; // What the colours count beside the contours.
const std::size_t everyScanned = 8;
const std::size_t everyAligned = 3;
// Maps of edges. Large poses are scanned for and first aligned with the coarse one.
const double coarseFrom = 120.;        // Of the object, pixels.
const double reachOfEdges = 16.;       // Pixels.
const double coarseScale = 0.25;       // Map pixels per image pixel.
const double reachOfCoarseEdges = 40.; // Pixels.
// About what was aligned.
const std::size_t mostStarts = 2000;
const vpPoseSearch::Spread firstSpread = {0.1, 0.3, 0.2};
const std::size_t layers = 4;
const std::size_t parents[layers] = {250, 100, 50, 25};
const std::size_t children[layers] = {6000, 2500, 1500, 750};
const std::size_t mostFound = 10;
const vpPoseSearch::Spread apart = {0.25, 0.4, 0.6};
// What a corner that agrees adds to a standing, and how many do so.
const double perCorner = 0.05;
const unsigned int mostCorners = 40;
// To be accepted. Of 71 right poses in 100 images of five objects, 67 had a standing of 4.8 and more, and 3 of 29 wrong
// ones; the correlation of right ones was 0.51 and more.
const double leastStanding = 4.8;
const double leastColors = 0.5;

template <typename Item> void keepBest(std::vector<Item> &items, std::size_t most)
{
  std::stable_sort(items.begin(), items.end(), [](const Item &a, const Item &b) { return a.score > b.score; });
  items.resize(std::min(items.size(), most));
}
} // namespace

vpImageSearch::Sizes vpImageSearch::sizes(const vpDistanceRange &distances, const vpTrackedModel &model,
                                          const vpCameraParameters &cam, unsigned int height)
{
  const double atOneMetre = cam.get_px() * model.diameter();
  Sizes sizes;
  sizes.most = distances.nearest > 0. ? atOneMetre / distances.nearest : mostOfHeight * height;
  sizes.least = distances.farthest > 0. ? atOneMetre / distances.farthest : leastOfHeight * height;
  if (!(sizes.most >= leastSize)) {
    throw vpException(vpException::badValue,
                      "At %g m the object spans %g pixels of the image: it can be found where it spans %g or more",
                      atOneMetre / sizes.most, sizes.most, leastSize);
  }
  sizes.most = std::min(sizes.most, mostHeights * height);
  sizes.least = std::min(std::max(sizes.least, leastSize), sizes.most);
  return sizes;
}

vpHomogeneousMatrix vpImageSearch::inTheMiddle(const vpTrackedModel &model, const vpCameraParameters &cam,
                                               const Sizes &sizes)
{
  const double depth = cam.get_px() * model.diameter() / std::sqrt(sizes.least * sizes.most);
  const Eigen::Vector3d centre = model.centre();
  return vpHomogeneousMatrix(-centre.x(), -centre.y(), depth - centre.z(), 0., 0., 0.);
}

void vpImageSearch::setFrame(const vpCueFrame &frame, vpViewSphere &sphere, vpModelRenderer::Preference preference,
                             const vpStartSearch &look)
{
  m_frame = &frame;
  m_look = &look;
  m_sphere = &sphere;
  m_preference = preference;
  const vpImageRegion all(0, 0, static_cast<int>(frame.width()), static_cast<int>(frame.height()));
  vpOrientedDistanceSettings settings;
  settings.maxDistance = reachOfEdges;
  m_edges.setSettings(settings);
  m_edges.compute(frame, all);
  settings.scale = coarseScale;
  settings.maxDistance = reachOfCoarseEdges;
  m_coarseEdges.setSettings(settings);
  m_coarseEdges.compute(frame, all);
  m_standing.setFrame(frame, sphere, m_edges, look);
  m_scan.setSphere(&sphere);
  m_aligner.setSphere(&sphere);
  m_coarseAligner.setSphere(&sphere);
  m_aligner.setImage(nullptr, &m_edges, frame.camera(), frame.width(), frame.height());
  m_coarseAligner.setImage(nullptr, &m_coarseEdges, frame.camera(), frame.width(), frame.height());
}

// Corners that agree are hardly so by chance, and tell a pose from one that explains a part of the object alone.
double vpImageSearch::standing(const vpHomogeneousMatrix &cMo, std::size_t every) const
{
  return m_standing(cMo, every) + perCorner * std::min(m_keyframes.agreeing(cMo), mostCorners);
}

// The best places for what a pose shows.
void vpImageSearch::addPlaces(const Eigen::Isometry3d &cMo, std::vector<Place> &places)
{
  std::vector<vpContourScan::Find> finds;
  m_scan.find(cMo, placesOfView, finds);
  const double trust = m_look->trust();
  for (const vpContourScan::Find &find : finds) {
    Place place;
    place.cMo = m_scan.movedTo(find, cMo);
    place.score = find.share + (trust > 0. ? scannedColors * trust * m_look->colorsAt(place.cMo, everyScanned) : 0.);
    places.push_back(place);
  }
}

std::vector<vpImageSearch::Place> vpImageSearch::scan(double size)
{
  m_scan.setImage(size > coarseFrom ? m_coarseEdges : m_edges, m_frame->camera(), m_frame->width(), m_frame->height(),
                  0.5 * size, cellsPerRadius, clutter);
  const Eigen::Vector3d at(0., 0., m_frame->camera().get_px() * m_sphere->model().diameter() / size);
  const Eigen::Vector3d middle = m_sphere->model().centre();
  const std::size_t sides = std::min(vpViewSphere::size(scannedLevel), m_sphere->size());
  std::vector<Place> places;
  for (std::size_t i = 0; i < sides; ++i) {
    const Eigen::Matrix3d side = vpPoseExponential::toEigen(m_sphere->poseOf(i)).linear();
    for (int k = 0; k < turns; ++k) {
      Eigen::Isometry3d cMo = Eigen::Isometry3d::Identity();
      cMo.linear() = Eigen::AngleAxisd(2. * M_PI * k / turns, Eigen::Vector3d::UnitZ()).toRotationMatrix() * side;
      cMo.translation() = at - cMo.linear() * middle;
      addPlaces(cMo, places);
    }
  }
  keepBest(places, placesOfSize);
  return places;
}

// Where the image's edges are near, or as it is where that is better.
vpPoseCandidate vpImageSearch::aligned(const Place &place)
{
  Eigen::Isometry3d cMo = place.cMo;
  for (const vpContourAligner *aligner :
       {m_standing.sizeOf(cMo) > coarseFrom ? &m_coarseAligner : &m_aligner, &m_aligner}) {
    for (int i = 0; i < 2 && aligner->stepByEdges(cMo); ++i) {
    }
  }
  const double before = m_standing.value(place.cMo, everyAligned);
  const double after = cMo.matrix().allFinite() ? m_standing.value(cMo, everyAligned) : -HUGE_VAL;
  return {vpPoseExponential::fromEigen(after > before ? cMo : place.cMo), std::max(before, after)};
}

// From the smallest to the largest, each with what is usual.
std::vector<vpPoseCandidate> vpImageSearch::scanAll(const Sizes &sizes)
{
  std::vector<vpPoseCandidate> all;
  const int steps = static_cast<int>(std::ceil(std::log(sizes.most / sizes.least) / std::log(sizeStep)));
  for (int i = 0; i <= steps; ++i) {
    const double share = steps > 0 ? static_cast<double>(i) / steps : 0.;
    const double size = sizes.least * std::pow(sizes.most / sizes.least, share);
    double sum = 0.;
    const std::vector<Place> places = scan(size);
    for (const Place &place : places) {
      all.push_back(aligned(place));
      sum += std::max(all.back().score, 0.);
    }
    m_standing.addUsual(size, sum / static_cast<double>(std::max<std::size_t>(places.size(), 1)));
  }
  for (vpPoseCandidate &candidate : all) {
    candidate.score -= m_standing.usualOf(m_standing.sizeOf(vpPoseExponential::toEigen(candidate.cMo)));
  }
  keepBest(all, mostStarts);
  return all;
}

// What is drawn slides to where the edges are before it is looked at, and is looked at where it was drawn, too.
void vpImageSearch::breed(vpPoseSearch &search, const vpPoseSearch::Spread &spread, std::size_t keep,
                          std::size_t number, bool isCoarse)
{
  const std::size_t scored = search.breed(spread, keep, number);
  search.keepCopies();
  if (isCoarse) {
    search.alignByEdges(m_coarseAligner, 2);
  }
  search.alignByEdges(m_aligner, 2);
  search.addCopies();
  m_every = isCoarse ? everyAligned : 1;
  search.score(isCoarse ? scored : 0);
}

std::vector<vpPoseCandidate> vpImageSearch::anneal(const std::vector<vpPoseCandidate> &starts, std::uint64_t seed)
{
  const auto score = [this](const vpHomogeneousMatrix &cMo) { return standing(cMo, m_every); };
  vpPoseSearch search(score, m_sphere->model(), seed);
  std::vector<vpHomogeneousMatrix> poses;
  for (const vpPoseCandidate &start : starts) {
    poses.push_back(start.cMo);
  }
  search.scatter(poses, firstSpread, 0);
  m_every = everyAligned;
  search.score();
  vpPoseSearch::Spread spread = firstSpread;
  for (std::size_t layer = 0; layer < layers; ++layer) {
    breed(search, spread, parents[layer], children[layer], layer == 0);
    spread = spread.halved();
  }
  search.keepBest(mostFound, apart);
  return search.candidates();
}

std::vector<vpPoseCandidate> vpImageSearch::find(const Sizes &sizes, std::uint64_t seed)
{
  std::vector<vpPoseCandidate> starts = scanAll(sizes);
  for (const vpKeyframePose &pose : m_keyframes.find(*m_frame, *m_sphere, m_preference)) {
    const double size = m_standing.sizeOf(vpPoseExponential::toEigen(pose.cMo));
    if (size >= sizes.least / sizeStep && size <= sizes.most * sizeStep) {
      starts.push_back({pose.cMo, 0.});
    }
  }
  return anneal(starts, seed);
}

std::string vpImageSearch::missing(const vpHomogeneousMatrix &cMo) const
{
  const double stands = standing(cMo);
  if (!(stands >= leastStanding)) {
    return "it is " + vpHundredths(stands) +
           " deviations better than what is found of this size in all of the image, " + vpHundredths(leastStanding) +
           " are needed";
  }
  const double trust = m_look->trust();
  const double colors = trust > 0. ? m_look->colorsAt(vpPoseExponential::toEigen(cMo), 1) : 0.;
  if (colors < trust * leastColors) {
    return "the image does not have the model's colours there (correlation " + vpHundredths(colors) + " of " +
           vpHundredths(trust * leastColors) + ")";
  }
  return "";
}

END_VISP_NAMESPACE
