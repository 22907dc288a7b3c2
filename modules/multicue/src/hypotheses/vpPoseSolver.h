// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseSolver_h
#define vpPoseSolver_h

#include "hypotheses/vpMotionFrame.h"

#include <visp3/core/vpRobust.h>
#include <visp3/cues/vpEdgeCue.h>

BEGIN_VISP_NAMESPACE

/*!
  ViSP's virtual visual servoing without a tracker: the robust weights of vpRobust, Gauss and Newton's step, and
  vpExponentialMap (through vpPoseExponential), with memory of its own, so that several minimisations can run side by
  side.
*/
class vpPoseSolver
{
public:
  /*!
    \param edges Matched; only read.
    \param choices The candidates to minimise the distances of, see vpEdgeCue::residuals(); null: always the nearest.
    \param freeMotions Motions that are estimated, a projector in the object frame.
    \param diameter Of the object, metres.
    \param cMo Start and result.
    \param iterations Largest number of them.
    \return False where the pose cannot be estimated.
  */
  bool minimise(const vpEdgeCue &edges, const std::vector<int> *choices, const vpPoseMatrix6 &freeMotions,
                double diameter, vpHomogeneousMatrix &cMo, unsigned int iterations);

  /*!
    \return Of the motions in \e freeMotions those that the image shows, a projector in the object frame: limbs and
    circles leave some that nothing shows. To be asked at the pose of the match, where the candidates are on the control
    points' normals; elsewhere their distances seem to tell of such motions. \param cMo That pose. \param diameter Of
    the object, metres.
  */
  vpPoseMatrix6 observed(const vpEdgeCue &edges, const vpPoseMatrix6 &freeMotions, double diameter,
                         const vpHomogeneousMatrix &cMo);

  //! Mean over the control points of the squared distance to the nearest candidate, square pixels. \param cutoff What a
  //! distance counts at most, and a control point without candidates, pixels.
  double error(const vpEdgeCue &edges, const vpHomogeneousMatrix &cMo, double cutoff);

private:
  bool step(const vpPoseMatrix6 &toCamera, vpPoseTangent &velocity);

  vpRobust m_robust;
  vpResidualBlock m_block;
  vpColVector m_error;
  vpColVector m_weights;
};

END_VISP_NAMESPACE
#endif
