// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpTrackerImpl.h"

BEGIN_VISP_NAMESPACE

vpMbMultiCueTracker::vpMbMultiCueTracker(unsigned int nbCameras) : vpMbMultiCueTracker()
{
  requireOneCamera(nbCameras);
}

vpMbMultiCueTracker::vpMbMultiCueTracker(unsigned int nbCameras, int trackerType)
    : m_impl(std::make_unique<Impl>(*this))
{
  requireOneCamera(nbCameras);
  setTrackerType(trackerType);
}

vpMbMultiCueTracker::vpMbMultiCueTracker(const std::vector<int> &trackerTypes) : m_impl(std::make_unique<Impl>(*this))
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

END_VISP_NAMESPACE
