// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/vpEverywhereSearch.h"

#include <algorithm>
#include <array>
#include <vector>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t drawnOfDetector = 300;
const double wideNumber = 2000.;
const double scannedShare = 1.5; // Orientations that are looked for in all of the image, for each pose that is drawn.
const double keptShare = 0.1;    // Likewise, of those the ones that fit best.
const double aroundFound = 50.;  // Each of the best poses of the frames before.
const std::size_t mostBlobs = 4;
// Of what is left of a frame with a deadline: the best poses have to be estimated, too.
const double shareOfSearch = 0.5;
// Side of a window that the object fills, in projected diameters.
const double windowShare = 0.5;
const double spreadPerFrame = 0.15; // Of the spread near the expected pose.
const vpPoseSearch::Spread atPlace = {0.08, vpPoseSearch::near().rotation, 0.15}; // That a colour showed.
const double depthPrior = 0.2; // Of a distance that is e times what it was.
// About poses at the distance that the object had.
const vpPoseSearch::Spread atDistance = {0.05, 0.15, 0.04};
const std::size_t atDistanceParents = 24;
const double atDistanceChildren = 200.;
const unsigned int atDistanceLayers = 2;
const std::size_t atDistanceAttempts = 2;

vpPoseSearch::Spread spreadWhileLost(unsigned int frames)
{
  return vpPoseSearch::near().grown(1. + spreadPerFrame * frames);
}

// The orientation of one pose at the place of another. \param point In the object's frame, is at that place.
vpHomogeneousMatrix turnedAt(const vpHomogeneousMatrix &place, const vpHomogeneousMatrix &orientation,
                             const Eigen::Vector3d &point)
{
  Eigen::Isometry3d pose = vpPoseExponential::toEigen(orientation);
  pose.translation() = vpPoseExponential::toEigen(place) * point - pose.linear() * point;
  return vpPoseExponential::fromEigen(pose);
}
} // namespace

void vpEverywhereSearch::search(const vpFrameContext &frame)
{
  if (searchDetected(frame) || !m_score.setFrameInTime(frame)) {
    return;
  }
  // The object may come back in other light, or show a side whose colours were never seen: every second search is one
  // by edges.
  const bool byEdges = m_cues.uses(vpCueSet::EDGE) && m_situation.framesSinceLoss % 2 == 0;
  m_size.begin(frame.deadline, shareOfSearch);
  const auto score = [this](const vpHomogeneousMatrix &cMo) {
    return m_score(cMo).total - depthPrior * m_whereabouts.depthChange(cMo);
  };
  vpPoseSearch search(score, m_looks.model(), frame.streams.searches++);
  search.setLimit(m_size.limit());
  search.setSymmetries(m_symmetries.get());
  scatter(frame, search);
  scatterScanned(frame, search);
  search.mix();
  if (byEdges) {
    m_score.weigh(true);
    m_score.settleByScore(search, m_size.share());
    m_score.weigh(false);
  } else {
    m_score.settle(search, m_size.share());
  }
  m_size.end(frame.deadline);
  if (search.isCutShort()) {
    frame.deadline.notePutOff(vpPutOff::SEARCH);
  }
  const std::vector<vpHomogeneousMatrix> atDepth = atTrustedDepth(search.candidates());
  const bool isEnough = m_attempts.attemptBest(frame, search, !byEdges);
  m_situation.searched.clear();
  for (const vpPoseCandidate &candidate : search.candidates()) {
    m_situation.searched.push_back(candidate.cMo);
  }
  if (!isEnough && !frame.deadline.putsOff(vpPutOff::STARTS)) {
    attemptAtDistance(frame, atDepth, byEdges);
  }
  m_situation.tracks.noteSearch();
}

// The likeliest poses about those that the detector gave. \return True where one of them is enough.
bool vpEverywhereSearch::searchDetected(const vpFrameContext &frame)
{
  if (m_rough.detected.empty()) {
    return false;
  }
  m_score.setFrame(frame);
  vpPoseSearch search(m_score.score(), m_looks.model(), frame.streams.searches++);
  search.setSymmetries(m_symmetries.get());
  search.scatter(m_rough.detected, vpPoseSearch::near(), drawnOfDetector);
  m_score.settle(search);
  return m_attempts.attemptBest(frame, search);
}

// Where much of the outline does not show, as that of a black part before the night sky, poses farther away score best:
// all of them fits into what does. Turned rightly, they lead to the right one from the distance that the object had.
void vpEverywhereSearch::attemptAtDistance(const vpFrameContext &frame, const std::vector<vpHomogeneousMatrix> &poses,
                                           bool byEdges)
{
  vpPoseSearch search(m_score.score(), m_looks.model(), frame.streams.searches++);
  search.setLimit(frame.deadline.after(shareOfSearch));
  search.setSymmetries(m_symmetries.get());
  search.scatter(poses, atDistance, 0);
  m_score.weigh(byEdges);
  search.score();
  search.anneal(atDistance, atDistanceParents, m_size.of(atDistanceChildren), atDistanceLayers);
  m_score.weigh(false);
  search.keepBest(atDistanceAttempts, vpPoseSearch::same());
  m_attempts.attemptBest(frame, search, false);
}

void vpEverywhereSearch::turnByHalf(const vpFrameContext &frame)
{
  if (m_attempts.best().explained < vpJudgedPose::leastExplained) {
    return;
  }
  const vpHomogeneousMatrix best = m_attempts.best().cMo;
  if (m_situation.confirmations == 1) {
    for (const vpHomogeneousMatrix &turned : m_halfTurns.turned(best)) {
      m_attempts.attempt(frame, {turned, vpStart::FINE});
    }
  } else if (const auto turned = m_halfTurns.nearer(best, m_whereabouts.poses())) {
    m_attempts.attempt(frame, {*turned, vpStart::FINE});
  }
}

// Poses moved along the line of sight to the distance that the object had.
std::vector<vpHomogeneousMatrix>
vpEverywhereSearch::atTrustedDepth(const std::vector<vpPoseCandidate> &candidates) const
{
  const Eigen::Vector3d centre = m_looks.model().centre();
  const double depth = m_whereabouts.depthOfOrigin();
  std::vector<vpHomogeneousMatrix> poses;
  for (const vpPoseCandidate &candidate : candidates) {
    Eigen::Isometry3d pose = vpPoseExponential::toEigen(candidate.cMo);
    const Eigen::Vector3d at = pose * centre;
    if (depth > 0. && at.z() > 0.) {
      pose.translation() += (depth / at.z() - 1.) * at;
      poses.push_back(vpPoseExponential::fromEigen(pose));
    }
  }
  return poses;
}

// Six numbers are too many to draw all of them far and wide: far places have likely orientations, and likely places all
// orientations.
void vpEverywhereSearch::scatter(const vpFrameContext &frame, vpPoseSearch &search)
{
  const std::size_t number = m_size.of(wideNumber);
  const vpPoseSearch::Spread near = vpPoseSearch::near();
  const vpPoseSearch::Spread wide = spreadWhileLost(m_situation.framesSinceLoss);
  const auto [before, moved, movedHalf] = m_whereabouts.fromOrigin();
  search.setPrior(m_whereabouts.poses(), wide, vpPoseSearch::Tail::HEAVY);
  search.scatter({m_motion.expected(), before}, wide, number / 8);
  const vpPoseSearch::Spread far = {std::max(0.5 * wide.translation, near.translation), near.rotation,
                                    std::max(0.5 * wide.depth, near.depth)};
  for (const vpHomogeneousMatrix &cMo : {moved, movedHalf}) {
    search.scatter({cMo, turnedAt(before, cMo, m_looks.model().centre())}, far, number / 8);
  }
  for (const Place &place : placesOfColors(frame)) {
    const auto all = static_cast<std::size_t>(0.5 * place.share * static_cast<double>(number));
    search.scatterAround(place.centre, before, {atPlace.translation, wide.rotation, atPlace.depth}, all);
    for (const vpHomogeneousMatrix &cMo : {moved, movedHalf}) {
      search.scatterAround(place.centre, cMo, atPlace, all / 2);
    }
  }
  for (const vpHomogeneousMatrix &cMo : m_situation.searched) {
    search.scatter({cMo}, near, m_size.of(aroundFound));
  }
}

// Likely orientations where their contours are found in the image: too many to draw the place of each as well.
void vpEverywhereSearch::scatterScanned(const vpFrameContext &frame, vpPoseSearch &search)
{
  const double depth = m_whereabouts.depthOfOrigin();
  if (!m_cues.uses(vpCueSet::EDGE) || !(depth > 0.)) {
    return;
  }
  const vpCueFrame &image = frame.image;
  vpContourScan &scan = m_score.contourScan();
  scan.setImage(m_score.distances(), image.camera(), image.width(), image.height(),
                0.5 * image.camera().get_px() * m_looks.model().diameter() / depth);
  const auto share = [this](double of) { return m_size.of(of * wideNumber); };
  vpPoseSearch drawn(m_score.score(), m_looks.model(), frame.streams.searches++);
  const auto [before, moved, movedHalf] = m_whereabouts.fromOrigin();
  const vpPoseSearch::Spread wide = spreadWhileLost(m_situation.framesSinceLoss);
  drawn.scatter({before, moved, movedHalf}, {0., wide.rotation, atPlace.depth}, share(scannedShare));
  std::vector<vpPoseCandidate> found;
  for (const vpPoseCandidate &candidate : drawn.candidates()) {
    if (m_size.limit().isOver()) {
      break;
    }
    const Eigen::Isometry3d cMo = vpPoseExponential::toEigen(candidate.cMo);
    const vpContourScan::Find find = scan.find(cMo);
    found.push_back({vpPoseExponential::fromEigen(scan.movedTo(find, cMo)), find.share});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const vpPoseCandidate &a, const vpPoseCandidate &b) { return a.score > b.score; });
  found.resize(std::min(found.size(), share(keptShare)));
  for (const vpPoseCandidate &candidate : found) {
    search.scatter({candidate.cMo}, wide, 0);
  }
}

// Where the image has the object's colours.
std::vector<vpEverywhereSearch::Place> vpEverywhereSearch::placesOfColors(const vpFrameContext &frame)
{
  std::vector<Place> places;
  if (!m_score.hasColors()) {
    return places;
  }
  const double depth = m_whereabouts.depthOfOrigin();
  const vpCameraParameters &cam = frame.image.camera();
  const double size = windowShare * cam.get_px() * m_looks.model().diameter() / depth;
  const std::vector<vpBlob> &found =
      m_blobs.find(m_score.odds(), frame.image.width(), frame.image.height(), size, mostBlobs);
  double total = 0.;
  for (const vpBlob &blob : found) {
    total += blob.contrast * blob.contrast;
  }
  for (const vpBlob &blob : found) {
    const double x = (blob.u - cam.get_u0()) / cam.get_px();
    const double y = (blob.v - cam.get_v0()) / cam.get_py();
    const double z = depth * std::min(std::max(size / blob.size, 0.8), 1.25);
    places.push_back({z * Eigen::Vector3d(x, y, 1.), blob.contrast * blob.contrast / total});
  }
  return places;
}

END_VISP_NAMESPACE
