// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <algorithm>
#include <array>
#include <vector>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t wideNumber = 2000;
const double scannedShare = 1.5; // Orientations that are looked for in all of the image, for each pose that is drawn.
const double keptShare = 0.1;    // Likewise, of those the ones that fit best.
const std::size_t aroundFound = 50; // Each of the best poses of the frames before.
const std::size_t mostBlobs = 4;
// Side of a window that the object fills, in projected diameters.
const double windowShare = 0.5;
const double spreadPerFrame = 0.15; // Of the spread near the expected pose.
const vpPoseSearch::Spread atPlace = {0.08, vpPoseSearch::near().rotation, 0.15}; // That a colour showed.
const double depthPrior = 0.2; // Of a distance that is e times what it was.
// About poses at the distance that the object had.
const vpPoseSearch::Spread atDistance = {0.05, 0.15, 0.04};
const std::size_t atDistanceParents = 24;
const std::size_t atDistanceChildren = 200;
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

// All around and in all of the image; the best poses of the frames before are among the starts.
void vpMbMultiCueTracker::searchEverywhere(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (searchDetected(frame) || impl.searchBudget.isSpent()) {
    return;
  }
  // The object may come back in other light, or show a side whose colours were never seen: every second search is one
  // by edges.
  const bool byEdges = impl.uses(EDGE_TRACKER) && impl.framesSinceLoss % 2 == 0;
  const double begin = impl.searchBudget.elapsed();
  const std::size_t number = impl.searchBudget.number(wideNumber);
  impl.scoreFrame(frame);
  const auto score = [&impl](const vpHomogeneousMatrix &cMo) {
    return impl.poseScore(cMo).total - depthPrior * impl.depthChange(cMo);
  };
  vpPoseSearch search(score, *impl.model, impl.draws++);
  search.setSymmetries(impl.symmetries.get());
  impl.scatterEverywhere(frame, search, number);
  impl.scatterScanned(frame, search, number);
  if (byEdges) {
    impl.weighScore(true);
    impl.settleByScore(search);
    impl.weighScore(false);
  } else {
    impl.settle(search);
  }
  impl.searchBudget.learn(number, begin, impl.searchBudget.elapsed() - begin);
  const std::vector<vpHomogeneousMatrix> atDepth = impl.atTrustedDepth(search.candidates());
  const bool isEnough = attemptBest(frame, search, !byEdges);
  impl.searched = search.candidates();
  if (!isEnough && !impl.searchBudget.isSpent()) {
    attemptAtDistance(frame, atDepth, byEdges);
  }
  impl.tracks.noteSearch();
}

// Where much of the outline does not show, as that of a black part before the night sky, poses farther away score best:
// all of them fits into what does. Turned rightly, they lead to the right one from the distance that the object had.
void vpMbMultiCueTracker::attemptAtDistance(const vpCueFrame &frame, const std::vector<vpHomogeneousMatrix> &poses,
                                            bool byEdges)
{
  Impl &impl = *m_impl;
  vpPoseSearch search(impl.poseScore, *impl.model, impl.draws++);
  search.setSymmetries(impl.symmetries.get());
  search.scatter(poses, atDistance, 0);
  impl.weighScore(byEdges);
  search.score();
  search.anneal(atDistance, atDistanceParents, atDistanceChildren, atDistanceLayers);
  impl.weighScore(false);
  search.keepBest(atDistanceAttempts, vpPoseSearch::same());
  attemptBest(frame, search, false);
}

// The best pose of this frame, where it is turned far, the other way round; and once it is about to be confirmed, all
// those that look much alike.
void vpMbMultiCueTracker::attemptHalfTurned(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (impl.best.explained < vpJudgedPose::leastExplained || impl.searchBudget.isSpent()) {
    return;
  }
  impl.usesPoints = false;
  const vpHomogeneousMatrix best = impl.best.cMo;
  if (impl.confirmations == 1) {
    for (const vpHomogeneousMatrix &turned : impl.halfTurns.turned(best)) {
      attemptFrom(frame, turned, false);
    }
  } else if (const auto turned = impl.halfTurns.nearer(best, impl.whereabouts())) {
    attemptFrom(frame, *turned, false);
  }
}

// Poses moved along the line of sight to the distance that the object had.
std::vector<vpHomogeneousMatrix>
vpMbMultiCueTracker::Impl::atTrustedDepth(const std::vector<vpPoseCandidate> &candidates) const
{
  const Eigen::Vector3d centre = model->centre();
  const double depth = depthOf(searchOrigin().cMo);
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
void vpMbMultiCueTracker::Impl::scatterEverywhere(const vpCueFrame &frame, vpPoseSearch &search, std::size_t number)
{
  const vpPoseSearch::Spread near = vpPoseSearch::near();
  const vpPoseSearch::Spread wide = spreadWhileLost(framesSinceLoss);
  const auto [before, moved, movedHalf] = whereaboutsOf(searchOrigin());
  search.setPrior(whereabouts(), wide, vpPoseSearch::usualPrior);
  search.scatter({expectedPose, before}, wide, number / 8);
  const vpPoseSearch::Spread far = {std::max(0.5 * wide.translation, near.translation), near.rotation,
                                    std::max(0.5 * wide.depth, near.depth)};
  for (const vpHomogeneousMatrix &cMo : {moved, movedHalf}) {
    search.scatter({cMo, turnedAt(before, cMo, model->centre())}, far, number / 8);
  }
  for (const Place &place : placesOfColors(frame)) {
    const auto all = static_cast<std::size_t>(0.5 * place.share * static_cast<double>(number));
    search.scatterAround(place.centre, before, {atPlace.translation, wide.rotation, atPlace.depth}, all);
    for (const vpHomogeneousMatrix &cMo : {moved, movedHalf}) {
      search.scatterAround(place.centre, cMo, atPlace, all / 2);
    }
  }
  for (const vpPoseCandidate &candidate : searched) {
    search.scatter({candidate.cMo}, near, aroundFound);
  }
}

// Likely orientations where their contours are found in the image: too many to draw the place of each as well.
void vpMbMultiCueTracker::Impl::scatterScanned(const vpCueFrame &frame, vpPoseSearch &search, std::size_t number)
{
  const double depth = depthOf(searchOrigin().cMo);
  if (!uses(EDGE_TRACKER) || !(depth > 0.)) {
    return;
  }
  const vpCameraParameters &cam = frame.camera();
  contourScan.setImage(distanceMap, cam, frame.width(), frame.height(), 0.5 * cam.get_px() * model->diameter() / depth);
  const auto share = [number](double of) { return static_cast<std::size_t>(of * static_cast<double>(number)); };
  vpPoseSearch drawn(poseScore, *model, draws++);
  const auto [before, moved, movedHalf] = whereaboutsOf(searchOrigin());
  const vpPoseSearch::Spread wide = spreadWhileLost(framesSinceLoss);
  drawn.scatter({before, moved, movedHalf}, {0., wide.rotation, atPlace.depth}, share(scannedShare));
  std::vector<vpPoseCandidate> found;
  for (const vpPoseCandidate &candidate : drawn.candidates()) {
    const Eigen::Isometry3d cMo = vpPoseExponential::toEigen(candidate.cMo);
    const vpContourScan::Find find = contourScan.find(cMo);
    found.push_back({vpPoseExponential::fromEigen(contourScan.movedTo(find, cMo)), find.share});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const vpPoseCandidate &a, const vpPoseCandidate &b) { return a.score > b.score; });
  found.resize(std::min(found.size(), share(keptShare)));
  for (const vpPoseCandidate &candidate : found) {
    search.scatter({candidate.cMo}, wide, 0);
  }
}

// Where the image has the object's colours.
std::vector<vpMbMultiCueTracker::Impl::Place> vpMbMultiCueTracker::Impl::placesOfColors(const vpCueFrame &frame)
{
  std::vector<Place> places;
  if (!uses(COLOR_TRACKER) || !color.histograms().isKnown()) {
    return places;
  }
  const double depth = depthOf(searchOrigin().cMo);
  const vpCameraParameters &cam = frame.camera();
  const double size = windowShare * cam.get_px() * model->diameter() / depth;
  const std::vector<vpBlob> &found = blobs.find(oddsMap, frame.width(), frame.height(), size, mostBlobs);
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
