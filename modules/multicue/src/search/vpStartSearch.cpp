// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpStartSearch.h"

#include "search/vpSameSide.h"

#include <visp3/se3/vpPoseRandom.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t drawn = 1000;
const std::size_t parents = 24;
const std::size_t children = 300;
const unsigned int layers = 3;
const std::size_t mostFound = 4;
// What is outside the image supports nothing.
const double outsideCost = 0.2;
// Elsewhere in the image.
const std::size_t drawnElsewhere = 200;
const std::size_t childrenElsewhere = 60;
const std::size_t mostTries = 100;
// How far they are from the pose at least, diameters in the image.
const double apart = 0.7;

// Turns the scene about the camera, so that the object appears elsewhere from the same side.
Eigen::Matrix3d turnTo(const Eigen::Vector3d &from, const Eigen::Vector3d &to, double roll)
{
  const Eigen::Vector3d sight = to.normalized();
  return Eigen::AngleAxisd(roll, sight).toRotationMatrix() * vpSmallestTurn(from, to);
}
} // namespace

void vpStartSearch::setFrame(const vpCueFrame &frame, vpViewSphere &sphere, vpModelRenderer::Preference preference,
                             bool usesColors)
{
  m_sphere = &sphere;
  m_camera = frame.camera();
  m_width = frame.width();
  m_height = frame.height();
  m_edges.compute(frame, {0, 0, static_cast<int>(frame.width()), static_cast<int>(frame.height())});
  m_usesColors = usesColors;
  if (usesColors) {
    m_colors.setFrame(frame, sphere, preference);
  }
  m_score.setSphere(&sphere);
  m_score.setImage(&m_edges, nullptr, nullptr, frame.camera(), frame.width(), frame.height());
}

vpStartSearch::Value vpStartSearch::operator()(const vpHomogeneousMatrix &cMo) const
{
  const vpPoseScore::Value seen = m_score(cMo);
  Value value;
  value.inside = seen.inside;
  if (!seen.isSeen) {
    return value;
  }
  value.edges = 1. - seen.distance;
  const double trust = this->trust();
  value.colors = trust > 0. ? m_colors.agreement(cMo) : 0.;
  value.seen = (value.edges + trust * value.colors) / (1. + trust);
  value.total = value.seen - outsideCost * (1. - seen.inside);
  return value;
}

vpPoseSearch vpStartSearch::search(const std::vector<vpWeightedPose> &starts, const vpPoseSearch::Spread &spread,
                                   std::uint64_t seed, std::size_t draws, std::size_t offspring, bool byColors) const
{
  const auto likeness = [this, byColors](const vpHomogeneousMatrix &cMo) {
    const Value value = (*this)(cMo);
    return byColors ? value.total : value.edges - outsideCost * (1. - value.inside);
  };
  vpPoseSearch search(likeness, m_sphere->model(), seed);
  std::vector<vpHomogeneousMatrix> poses;
  for (const vpWeightedPose &start : starts) {
    poses.push_back(start.cMo);
  }
  search.setPrior(poses, spread, vpPoseSearch::Tail::LIGHT);
  search.scatter(starts, spread, draws);
  search.score();
  search.anneal(spread, parents, offspring, layers);
  return search;
}

std::vector<vpPoseCandidate> vpStartSearch::find(const std::vector<vpWeightedPose> &starts,
                                                 const vpPoseSearch::Spread &spread, std::uint64_t seed) const
{
  // The light may change the colours beyond recognition: edges alone are asked as well.
  std::vector<vpPoseCandidate> all;
  for (const bool byColors : {true, false}) {
    if (byColors && !(trust() > 0.)) {
      continue;
    }
    vpPoseSearch found = search(starts, spread, seed, drawn, children, byColors);
    found.keepBest(mostFound, vpPoseSearch::same());
    all.insert(all.end(), found.candidates().begin(), found.candidates().end());
  }
  return all;
}

std::vector<vpStartSearch::Value> vpStartSearch::clutter(const vpHomogeneousMatrix &cMo,
                                                         const vpPoseSearch::Spread &spread, std::uint64_t seed,
                                                         std::size_t places) const
{
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
  const Eigen::Vector3d from = pose * m_sphere->model().centre();
  const double size = m_camera.get_px() * m_sphere->model().diameter() / from.z();
  const Eigen::Vector2d at(m_camera.get_px() * from.x() / from.z() + m_camera.get_u0(),
                           m_camera.get_py() * from.y() / from.z() + m_camera.get_v0());
  vpPoseRandom random(seed, {1});
  std::vector<Value> best;
  for (std::size_t i = 0; best.size() < places; ++i) {
    const Eigen::Vector2d place(m_width * random.uniform(), m_height * random.uniform());
    double roll = 2. * M_PI * random.uniform();
    if ((place - at).norm() < apart * size) {
      if (i < mostTries) {
        continue;
      }
      roll = M_PI / 3. + 2. / 3. * roll; // The object fills the image: turned in the image by 60 degrees or more.
    }
    const Eigen::Vector3d to((place.x() - m_camera.get_u0()) / m_camera.get_px(),
                             (place.y() - m_camera.get_v0()) / m_camera.get_py(), 1.);
    const vpHomogeneousMatrix other = vpPoseExponential::fromEigen(Eigen::Isometry3d(turnTo(from, to, roll)) * pose);
    const vpPoseSearch found = search({{other, 1.}}, spread, seed + i, drawnElsewhere, childrenElsewhere, true);
    best.push_back((*this)(found.candidates().front().cMo));
  }
  return best;
}

END_VISP_NAMESPACE
