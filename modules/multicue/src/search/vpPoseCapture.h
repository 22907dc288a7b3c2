// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseCapture_h
#define vpPoseCapture_h

#include "frame/vpFrameDeadline.h"
#include "hypotheses/vpPoseSolver.h"

#include <visp3/cues/vpCueFrame.h>
#include <visp3/model/vpModelView.h>
#include <visp3/se3/vpPoseRandom.h>

#include <functional>
#include <vector>

BEGIN_VISP_NAMESPACE

/*
  Finds the pose near one that is some pixels off, by the edges of one image and no memory of any other.

  While a pose is off, the edge nearest to a contour is often another one, of the print beside the border for instance,
  and a minimisation of nearest distances ends there. So each start is brought to the image from coarse to fine: at
  first the strongest edge on a long search line counts, and the nearer the pose is taken to be, the more the nearest
  (vpEdgeCue::setUncertainty()). That is done from the pose that is given and from some around it, and what the image
  says of the results decides, with how far they are from the given one.
*/
class vpPoseCapture
{
public:
  // The view of a pose in the image; it has to last until the next call.
  using ViewAt = std::function<const vpModelView &(const vpHomogeneousMatrix &cMo)>;

  struct Result
  {
    vpHomogeneousMatrix cMo;
    double evidence = -HUGE_VAL; // See vpEdgeCue::evidence().
    double value = -HUGE_VAL;    // The same, less what the distance from the given pose speaks against it.
  };

  // The given pose where no other one is better by much. reach: how far off the start may be, in usual offsets.
  // settings: how edges are searched for once the pose is right. freeMotions: see vpPoseSolver. stream: of random
  // numbers. deadline: those around the given pose are tried as long as there is time.
  Result find(const vpCueFrame &frame, const vpTrackedModel &model, const vpHomogeneousMatrix &start, double reach,
              const vpEdgeCueSettings &settings, const vpPoseMatrix6 &freeMotions, const ViewAt &viewAt,
              std::uint64_t stream, vpFrameDeadline &deadline);

private:
  Result judge(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &start, double offset,
               const vpEdgeCueSettings &settings, const ViewAt &viewAt);
  static vpHomogeneousMatrix drawn(const vpHomogeneousMatrix &start, const vpTrackedModel &model, double pixels,
                                   const vpCameraParameters &cam, vpPoseRandom random);
  bool refine(const vpCueFrame &frame, const vpEdgeCueSettings &settings, const vpPoseMatrix6 &freeMotions,
              const ViewAt &viewAt, vpHomogeneousMatrix &cMo);

  vpEdgeCue m_edges;
  vpPoseSolver m_solver;
};

END_VISP_NAMESPACE
#endif
