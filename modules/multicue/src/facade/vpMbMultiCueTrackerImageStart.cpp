// SPDX-License-Identifier: GPL-2.0-or-later
#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpExactNumber.h>

#include <cmath>

// Starts without a pose.

BEGIN_VISP_NAMESPACE

void vpDistanceRange::check() const
{
  const auto require = [](const char *name, double value) {
    if (!(value >= 0.) || !std::isfinite(value)) {
      throw vpException(vpException::badValue, "vpDistanceRange::%s is %g m: give 0 or more", name, value);
    }
  };
  require("nearest", nearest);
  require("farthest", farthest);
  if (!vpIsZero(farthest) && farthest < nearest) {
    throw vpException(vpException::badValue, "vpDistanceRange::farthest is %g m, less than nearest, %g m", farthest,
                      nearest);
  }
}

bool vpMbMultiCueTracker::initFromImage(const vpImage<unsigned char> &I, const vpDistanceRange &distances)
{
  return m_impl->startAnywhereOn(I, distances);
}

bool vpMbMultiCueTracker::initFromImage(const vpImage<vpRGBa> &I_color, const vpDistanceRange &distances)
{
  return m_impl->startAnywhereOn(I_color, distances);
}

template <typename Pixel>
bool vpMbMultiCueTracker::Impl::startAnywhereOn(const vpImage<Pixel> &I, const vpDistanceRange &distances)
{
  requireTrackable(I.getWidth(), I.getHeight());
  distances.check();
  const vpCueFrame image = source.frame(I, m_tracker.m_cam, m_tracker.m_mask);
  // Until the object is found, where most of the images that show it have it: in the middle.
  const vpImageSearch::Sizes sizes =
      vpImageSearch::sizes(distances, m_engine.looks.model(), image.camera(), image.height());
  start(vpImageSearch::inTheMiddle(m_engine.looks.model(), image.camera(), sizes), I.getWidth(), I.getHeight());
  bool isAccepted = false;
  estimate([&](vpHomogeneousMatrix &cMo) { isAccepted = m_engine.startAnywhere(image, sizes, cMo); });
  m_tracker.followFaces(I.getWidth(), I.getHeight());
  return isAccepted;
}

END_VISP_NAMESPACE
