// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "motion/vpPoseCheck.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t drawn = 80;
const std::size_t mostStarts = 4;
const std::size_t drawnOfDetector = 300;
// By how much a hint has to be better than the pose that is tracked.
const double leastGain = 0.05;
} // namespace

void vpMbMultiCueTracker::setDetector(const vpPoseDetector &detector)
{
  m_impl->rough.detector = detector;
}

// While the object is lost, or found again and not confirmed.
void vpMbMultiCueTracker::askDetector(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpRoughStart &rough = impl.rough;
  rough.detected.clear();
  rough.detectorText.clear();
  const bool isLost = impl.state == vpTrackingState::LOST || impl.mustConfirm;
  if (!rough.detector || !impl.searches || !isLost) {
    return;
  }
  const vpPoseDetector detector = rough.detector; // It may remove itself.
  try {
    if (frame.hasColor()) {
      takeDetected(detector(frame.color(), frame.camera()));
    } else {
      vpImage<vpRGBa> I;
      vpImageConvert::convert(frame.gray(), I);
      takeDetected(detector(I, frame.camera()));
    }
  } catch (const vpException &e) {
    rough.detectorText = std::string("the detector failed: ") + e.getMessage();
  } catch (const std::exception &e) {
    rough.detectorText = std::string("the detector failed: ") + e.what();
  } catch (...) {
    rough.detectorText = "the detector failed with an exception of unknown type";
  }
}

void vpMbMultiCueTracker::takeDetected(const std::vector<vpWeightedPose> &poses)
{
  Impl &impl = *m_impl;
  vpRoughStart &rough = impl.rough;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    try {
      vpPoseCheck::requireRigid(poses[i].cMo);
      vpPoseCheck::requireInView(*impl.model, poses[i].cMo, impl.frameCamera, impl.width, impl.height);
      if (!(poses[i].weight > 0.) || !std::isfinite(poses[i].weight)) {
        throw vpException(vpException::badValue, "Its weight is %g, it must be above 0", poses[i].weight);
      }
      rough.detected.push_back(poses[i]);
    } catch (const vpException &e) {
      rough.detectorText = "pose " + std::to_string(i) + " of the detector is passed over: " + e.getMessage();
    }
  }
  if (!rough.detected.empty()) {
    rough.depths.clear();
    for (const vpWeightedPose &pose : rough.detected) {
      rough.depths.push_back(impl.depthOf(pose.cMo));
    }
  }
}

// The likeliest poses about those that the detector gave. \return True where one of them is enough.
bool vpMbMultiCueTracker::searchDetected(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const std::vector<vpWeightedPose> &detected = impl.rough.detected;
  if (detected.empty()) {
    return false;
  }
  impl.scoreFrame(frame);
  vpPoseSearch search(impl.poseScore, *impl.model, impl.draws++);
  search.setSymmetries(impl.symmetries.get());
  search.scatter(detected, vpPoseSearch::near(), drawnOfDetector);
  impl.settle(search);
  return attemptBest(frame, search);
}

void vpMbMultiCueTracker::setPoseHint(const vpHomogeneousMatrix &cMo, const vpPoseDeviation &deviation)
{
  m_impl->requireModel();
  deviation.check();
  vpPoseCheck::requireRigid(cMo);
  if (!(m_impl->depthOf(cMo) > 0.)) {
    throw vpException(vpException::badValue, "At the hint's pose the object is behind the camera (z = %g m)",
                      cMo[2][3]);
  }
  m_impl->rough.hint = cMo;
  m_impl->rough.hintDeviation = deviation;
  m_impl->rough.hasHint = true;
}

// The likeliest poses about the hint by what was learnt; it is used up.
std::vector<vpHomogeneousMatrix> vpMbMultiCueTracker::hintStarts(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpRoughStart &rough = impl.rough;
  rough.hasHint = false;
  rough.depths = {impl.depthOf(rough.hint)};
  impl.scoreFrame(frame);
  vpPoseSearch search(impl.poseScore, *impl.model, impl.draws++);
  search.scatter(std::vector<vpHomogeneousMatrix>{rough.hint},
                 vpRoughStart::spreadOf(rough.hintDeviation, impl.model->diameter()), drawn);
  impl.settle(search);
  search.keepBest(mostStarts - 1, vpPoseSearch::same());
  capture(frame, rough.hint, 1.); // It may be some pixels off, as a start.
  std::vector<vpHomogeneousMatrix> starts = {rough.hint, m_cMo};
  for (const vpPoseCandidate &candidate : search.candidates()) {
    starts.push_back(candidate.cMo);
  }
  return starts;
}

// With several cues: one more attempt, as likely beforehand as the expected pose. \return True where it was taken and
// explains enough.
bool vpMbMultiCueTracker::tryHint(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix expected = impl.expectedPose;
  const Impl::Attempt before = impl.best;
  impl.usesPoints = false;
  bool isEnough = false;
  for (const vpHomogeneousMatrix &start : hintStarts(frame)) {
    impl.expectedPose = start;
    isEnough = attemptFrom(frame, start);
  }
  if (impl.best.value > before.value + leastGain) {
    impl.expectedPose = impl.best.cMo; // That it moved so far is no surprise.
    impl.forgetMotion();
    return isEnough;
  }
  impl.expectedPose = expected;
  impl.best = before;
  impl.bestIsLast = false;
  return false;
}

// With edges alone: the pose that was tracked and that of the hint by the edges of the image.
void vpMbMultiCueTracker::compareHint(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpStartSearch &search = impl.rough.search;
  const vpHomogeneousMatrix tracked = m_cMo;
  const bool isLost = impl.state == vpTrackingState::LOST;
  search.setFrame(frame, impl.viewSphere(), impl.preference, impl.viewOptions.textureEdges);
  const double before = isLost ? 0. : search(m_cMo).total;
  const auto references = impl.edges;
  double best = before + leastGain;
  vpHomogeneousMatrix taken;
  bool isTaken = false;
  for (const vpHomogeneousMatrix &start : hintStarts(frame)) {
    m_cMo = start;
    impl.edges.reset();
    const double value = estimateFrom(frame, false) ? search(m_cMo).total : -HUGE_VAL;
    if (value > best) {
      best = value + leastGain; // The hint itself comes first, and is likelier than those about it.
      taken = m_cMo;
      isTaken = true;
    }
  }
  if (isTaken) {
    m_cMo = taken;
    impl.forgetMotion();
  } else {
    m_cMo = tracked;
    impl.edges = references;
  }
  if (isTaken || !isLost) {
    judgeByEvidence(estimateFrom(frame, false));
    if (impl.edgesBeforeLoss) {
      confirmByEvidence(frame);
    }
  }
}

END_VISP_NAMESPACE
