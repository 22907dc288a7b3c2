// SPDX-License-Identifier: GPL-2.0-or-later
// A program that is built with the flags of pkg-config alone: it makes a tracker, and reads no file.
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <visp3/core/vpException.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

int main()
{
  vpMbMultiCueTracker tracker;
  tracker.setPreset(vpMbMultiCueTracker::Preset::FAST);
  try {
    tracker.loadModel("no such file.obj");
  } catch (const vpException &) {
    return tracker.getTrackingState() == vpTrackingState::UNCERTAIN ? 0 : 1;
  }
  return 1;
}
