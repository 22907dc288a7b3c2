// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

BEGIN_VISP_NAMESPACE

// Goes to the pose near another one that the image shows, or to that one. \param reach How far off it may be, in the
// usual offsets of a start.
void vpMbMultiCueTracker::capture(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, double reach)
{
  Impl &impl = *m_impl;
  const auto viewAt = [&](const vpHomogeneousMatrix &pose) -> const vpModelView & {
    computeView(frame, pose);
    return *impl.view;
  };
  const vpModelView before = viewAt(cMo);
  const vpPoseCapture::Result found =
      impl.poseCapture.find(frame, cMo, reach, impl.edges.settings(), impl.freeMotions(oJo), viewAt, impl.captures++);
  impl.view->continueFrom(before); // The poses that were tried saw other faces.
  m_cMo = found.cMo;
}

// The pose that the user gave may be some pixels off, as one that was clicked is: where the image shows the object near
// it, tracking starts there, and what is learnt of the object is learnt there. The pose itself stays until an image is
// tracked.
void vpMbMultiCueTracker::captureStart(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix given = m_cMo;
  impl.frameCamera = frame.camera();
  capture(frame, given, 1.);
  impl.trust(m_cMo);
  learnStart(frame);
  impl.captured = m_cMo;
  m_cMo = given;
}

END_VISP_NAMESPACE
