// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "motion/vpPoseCheck.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

vpMbMultiCueTracker::vpMbMultiCueTracker(unsigned int nbCameras) : vpMbMultiCueTracker()
{
  requireOneCamera(nbCameras);
}

vpMbMultiCueTracker::vpMbMultiCueTracker(unsigned int nbCameras, int trackerType) : m_impl(std::make_unique<Impl>())
{
  requireOneCamera(nbCameras);
  setTrackerType(trackerType);
}

vpMbMultiCueTracker::vpMbMultiCueTracker(const std::vector<int> &trackerTypes) : m_impl(std::make_unique<Impl>())
{
  requireOneCamera(trackerTypes.size());
  setTrackerType(trackerTypes.front());
}

vpMbMultiCueTracker::vpMbMultiCueTracker(const std::vector<std::string> &cameraNames,
                                         const std::vector<int> &trackerTypes)
    : vpMbMultiCueTracker(trackerTypes)
{
  requireOneCamera(cameraNames.size());
  m_referenceCameraName = cameraNames.front();
}

void vpMbMultiCueTracker::requireStart(unsigned int width, unsigned int height, const vpTrackedModel &model,
                                       const vpHomogeneousMatrix &cMo) const
{
  if (width == 0 || height == 0) {
    throw vpException(vpException::dimensionError, "The image is empty (%u x %u): give one with pixels", width, height);
  }
  vpPoseCheck::requireRigid(cMo);
  vpPoseCheck::requireInView(model, cMo, m_cam, width, height);
}

// A detector is wrong at times, and a loop that takes its poses has to go on.
bool vpMbMultiCueTracker::isFollowable(const vpHomogeneousMatrix &cMo, unsigned int width, unsigned int height)
{
  requireTrackable(width, height);
  vpPoseCheck::requireRigid(cMo);
  Impl &impl = *m_impl;
  try {
    vpPoseCheck::requireInView(*impl.model, cMo, m_cam, width, height);
  } catch (const vpException &e) {
    impl.state = vpTrackingState::LOST;
    impl.outcome = vpMbTrackingResult::Reason::NOTHING_SEEN;
    impl.reason = e.getMessage();
    impl.expected = 0;
    impl.good = 0;
    impl.supportOf.fill(Impl::Support());
    return false;
  }
  return true;
}

template <typename Pixel> void vpMbMultiCueTracker::setPoseOn(const vpImage<Pixel> &I, const vpHomogeneousMatrix &cdMo)
{
  if (isFollowable(cdMo, I.getWidth(), I.getHeight())) {
    m_cMo = cdMo;
    startOn(I);
  }
}

void vpMbMultiCueTracker::setPose(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cdMo)
{
  setPoseOn(I, cdMo);
}

void vpMbMultiCueTracker::setPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cdMo)
{
  setPoseOn(I_color, cdMo);
}

void vpMbMultiCueTracker::setKltThresholdAcceptation(double threshold)
{
  vpPointCueSettings settings = m_impl->klt;
  settings.leastWeight = threshold;
  settings.check();
  m_impl->klt = settings;
  m_impl->makeCues();
}

double vpMbMultiCueTracker::getKltThresholdAcceptation() const
{
  return m_impl->klt.leastWeight;
}

void vpMbMultiCueTracker::setFeatureFactors(const std::map<vpTrackerType, double> &mapOfFeatureFactors)
{
  for (const auto &[cue, factor] : mapOfFeatureFactors) {
    const bool isCue = cue == EDGE_TRACKER || cue == KLT_TRACKER || cue == COLOR_TRACKER;
    if (!isCue || !(factor > 0.) || !(factor < 1e6)) {
      throw vpException(vpException::badValue,
                        "The factor of cue %d is %g: give EDGE_TRACKER, KLT_TRACKER or COLOR_TRACKER a factor above 0 "
                        "and below 1e6, and leave cues out by setTrackerType()",
                        static_cast<int>(cue), factor);
    }
  }
  for (const auto &[cue, factor] : mapOfFeatureFactors) {
    m_impl->featureFactors[cue] = factor;
  }
}

END_VISP_NAMESPACE
