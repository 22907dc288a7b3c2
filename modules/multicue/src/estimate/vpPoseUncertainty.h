// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseUncertainty_h
#define vpPoseUncertainty_h

#include "estimate/vpCueFusion.h"

#include <visp3/multicue/vpCueKind.h>

BEGIN_VISP_NAMESPACE

/*!
  Covariance of the pose's error, of all cues together and of each alone ([P14] eq. 14).

  With D the robust weights, the pose's error is (D J)^+ D e, so its covariance is H^-1 G H^-1: H holds the rows by the
  weight that the minimisation gave them, G by the variance that their errors have. The two differ, because the
  minimisation does not believe errors below vpResidualBlock::noise, and because neighbours on a contour are wrong
  together. Three things are measured on the errors of the frame itself:
  - the variance of each row, by its own error (White, "A heteroskedasticity-consistent covariance matrix estimator",
    1980), for contrast and texture differ from place to place; with a robust estimator's correction for what its
  weights cut off (Huber, "Robust regression: asymptotics, conjectures and Monte Carlo", 1973);
  - the rows that the fit used up, a share of 6 for each cue;
  - how many rows count as one: 1 + 2 (rho_1 + rho_2 + ...), rho_k being the correlation of rows that are k apart, as
    far as it is above its own noise.
  A shift of all errors alike, vpResidualBlock::bias, comes on top.
*/
class vpPoseUncertainty
{
public:
  //! \param fusion After the minimisation. \param prior Inverse covariance of what is known without the image.
  void update(const vpCueFusion &fusion, const vpPoseMatrix6 &prior);
  //! \param fixed Motions that were not estimated, object frame: true where it is. \param cMo The pose.
  void setFrame(const vpHomogeneousMatrix &cMo, const std::array<bool, 6> &fixed);

  //! Of alpha, where exp(alpha) cMo is the true pose: camera frame, metres and radians.
  vpPoseMatrix6 covariance() const;
  //! Likewise by a part of the fusion alone.
  vpPoseMatrix6 covariance(std::size_t part) const;

private:
  struct Share
  {
    vpPoseMatrix6 weighed = vpPoseMatrix6::Zero(); // H
    vpPoseMatrix6 spread = vpPoseMatrix6::Zero();  // G
  };

  void weigh(const vpCueFusion::Part &part, Share &share) const;
  void spread(const vpCueFusion::Part &part, double fitted, Share &share);
  double correlatedRows();
  vpPoseMatrix6 invert(const vpPoseMatrix6 &weighed, const vpPoseMatrix6 &spread) const;

  std::array<Share, vpCueKinds::most> m_shares;
  std::size_t m_count = 0;
  vpPoseMatrix6 m_prior = vpPoseMatrix6::Identity();
  vpPoseMatrix6 m_cVo = vpPoseMatrix6::Identity();
  std::array<bool, 6> m_fixed{};
  std::vector<double> m_pulls; // Scratch memory: weighted errors of a part.
};

END_VISP_NAMESPACE
#endif
