// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpTrackerState.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t nearNumber = 80;
const std::size_t scoredNumber = 400; // Where colours do not help, from the near spread and from a wider one each.
const double widerFactor = 1.6;
const std::size_t modeNumber = 10; // Around each mode of the particles.
const std::size_t keptParents = 24;
const std::size_t children = 200;
const unsigned int layers = 3;
const std::size_t mostAttempts = 4;

// Everywhere: while the object is lost.
const std::size_t wideNumber = 2000;
const double steadyReliability = 0.6; // Of colours, which below it may lead away from the object.
const std::size_t mostBlobs = 4;
// Side of a window that the object fills, in projected diameters.
const double windowShare = 0.5;
const double mostShift = 1.5;       // Beyond it, shifts are equally unlikely.
const double spreadPerFrame = 0.15; // Of the spread near the expected pose.

// The best poses after a first alignment, with those that were not to be lost by it.
void keepSettled(vpPoseSearch &search)
{
  search.addCopies();
  search.score();
  search.keepBest(4 * keptParents, {0.04, 0.12, 0.08});
}

// Poses that were aligned are near to what they can become.
void annealSettled(vpPoseSearch &search)
{
  search.score();
  search.anneal({0.05, 0.15, 0.08}, keptParents, children, layers - 1);
}
} // namespace

// One more start. \param byColors Their coarse levels come first, which reach far. \return True where the pose that it
// leads to is enough.
bool vpMbMultiCueTracker::attemptFrom(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, bool byColors)
{
  Impl &impl = *m_impl;
  m_cMo = impl.nearestAlike(cMo);
  impl.startPose = m_cMo;
  updateView(frame, m_cMo, 0.);
  if (byColors && impl.uses(COLOR_TRACKER)) {
    estimateByCoarseColors(frame);
  }
  return takeAttempt(refineFused(frame));
}

// The likeliest poses around the one that is expected, the best ones estimated with all cues.
void vpMbMultiCueTracker::searchNear(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.scoreFrame(frame);
  vpPoseSearch search(impl.poseScore, *impl.model, impl.draws++);
  search.setSymmetries(impl.symmetries.get());
  search.setPrior(impl.expectedPose, vpPoseSearch::near(), vpPoseSearch::usualPrior);
  search.scatter({impl.expectedPose}, vpPoseSearch::near(), nearNumber);
  for (const vpPoseMode &mode : getPoseModes()) { // What the frames before left open.
    search.scatter({mode.cMo}, vpPoseSearch::same(), modeNumber);
  }
  impl.settle(search);
  if (attemptBest(frame, search) || impl.searchBudget.isSpent()) {
    return;
  }
  // Colours led away from the object, or there are none.
  vpPoseSearch again(impl.poseScore, *impl.model, impl.draws++);
  again.setSymmetries(impl.symmetries.get());
  const vpPoseSearch::Spread wider = vpPoseSearch::near().grown(widerFactor);
  again.setPrior(impl.expectedPose, wider, vpPoseSearch::usualPrior);
  again.scatter({impl.expectedPose}, vpPoseSearch::near(), scoredNumber);
  again.scatter({impl.expectedPose}, wider, scoredNumber);
  impl.settleByScore(again);
  attemptBest(frame, again, false);
}

// The best poses of a search, estimated with all cues. \return True where one of them is enough.
bool vpMbMultiCueTracker::attemptBest(const vpCueFrame &frame, vpPoseSearch &search, bool byColors)
{
  search.keepBest(mostAttempts, vpPoseSearch::same());
  bool isEnough = false;
  for (const vpPoseCandidate &candidate : search.candidates()) {
    isEnough = attemptFrom(frame, candidate.cMo, byColors);
    if (isEnough || m_impl->searchBudget.isSpent()) {
      break;
    }
  }
  return isEnough;
}

// All around and in all of the image; the best poses of the frames before are among the starts.
void vpMbMultiCueTracker::searchEverywhere(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  if (searchDetected(frame) || impl.searchBudget.isSpent()) {
    return;
  }
  // Colours that come and go may hide the object: every second search is one by edges.
  const bool byEdges = impl.uses(EDGE_TRACKER) && impl.hasUnsteadyColors() && impl.lostFrames % 2 == 1;
  const double begin = impl.searchBudget.elapsed();
  const std::size_t number = impl.searchBudget.number(wideNumber);
  impl.scoreFrame(frame);
  vpPoseSearch search(impl.poseScore, *impl.model, impl.draws++);
  search.setSymmetries(impl.symmetries.get());
  const double growth = 1. + spreadPerFrame * impl.lostFrames;
  const vpPoseSearch::Spread spread = vpPoseSearch::near().grown(growth);
  search.setPrior(impl.trusted, spread, vpPoseSearch::usualPrior);
  search.scatter({impl.expectedPose, impl.trusted}, spread, number / 4);
  impl.scatterOverBlobs(frame, search, spread.rotation, number);
  for (const vpPoseCandidate &candidate : impl.searched) {
    search.scatter({candidate.cMo}, vpPoseSearch::near(), children / mostAttempts);
  }
  if (byEdges) {
    impl.weighScore(true);
    impl.settleByScore(search);
    impl.weighScore(false);
  } else {
    impl.settle(search);
  }
  impl.searchBudget.learn(number, begin, impl.searchBudget.elapsed() - begin);
  attemptBest(frame, search, !byEdges);
  impl.searched = search.candidates();
  impl.tracks.noteSearch();
}

// Of half a turn, and of two diameters.
double vpMbMultiCueTracker::Impl::changeSince(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Isometry3d before = vpPoseExponential::toEigen(trusted);
  const Eigen::Isometry3d now = vpPoseExponential::toEigen(cMo);
  const Eigen::Matrix3d turn = before.linear().transpose() * now.linear();
  const Eigen::Vector3d centre = model->centre();
  const double shift = (now * centre - before * centre).norm() / (2. * model->diameter());
  return Eigen::AngleAxisd(turn).angle() / M_PI + std::min(shift, mostShift);
}

double vpMbMultiCueTracker::Impl::insideShare(const vpHomogeneousMatrix &cMo)
{
  vpPoseScore outline; // What poseScore looks at stays as it is.
  outline.setSphere(&viewSphere());
  outline.setImage(nullptr, nullptr, nullptr, frameCamera, width, height);
  return outline(cMo).inside;
}

bool vpMbMultiCueTracker::Impl::hasUnsteadyColors() const
{
  return reliability(unsteadiness.color) < steadyReliability;
}

// From poses drawn far and wide to a few that are as good as they can be told from views made beforehand.
void vpMbMultiCueTracker::Impl::settle(vpPoseSearch &search)
{
  if (!uses(COLOR_TRACKER) || !color.histograms().isKnown()) {
    settleByScore(search);
    return;
  }
  if (hasUnsteadyColors()) {
    search.keepCopies(); // Poses are looked at where they were drawn, too.
  }
  search.alignByColors(aligner, 0.15, 2);
  search.alignByColors(aligner, 0.08, 1);
  keepSettled(search);
  search.alignByColors(aligner, 0.05, 2);
  annealSettled(search);
}

void vpMbMultiCueTracker::Impl::settleByScore(vpPoseSearch &search) const
{
  if (!uses(EDGE_TRACKER)) {
    search.score();
    search.anneal(vpPoseSearch::near(), keptParents, children, layers);
    return;
  }
  search.keepCopies(); // Where edges are many, the nearest ones may lead away from the object's.
  search.alignByEdges(aligner, 3);
  keepSettled(search);
  search.alignByEdges(aligner, 2);
  annealSettled(search);
}

// Orientations at the places that have the object's colours.
void vpMbMultiCueTracker::Impl::scatterOverBlobs(const vpCueFrame &frame, vpPoseSearch &search, double rotation,
                                                 std::size_t number)
{
  if (!uses(COLOR_TRACKER) || !color.histograms().isKnown()) {
    return;
  }
  const double depth = (vpPoseExponential::toEigen(trusted) * model->centre()).z();
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
    const double share = blob.contrast * blob.contrast / total;
    search.scatterAround(z * Eigen::Vector3d(x, y, 1.), trusted, {0.08, rotation, 0.15},
                         static_cast<std::size_t>(share * static_cast<double>(number)));
  }
}

END_VISP_NAMESPACE
