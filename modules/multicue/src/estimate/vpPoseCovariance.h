// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseCovariance_h
#define vpPoseCovariance_h

#include "estimate/vpModelLooks.h"
#include "estimate/vpPoseUncertainty.h"

#include <optional>

BEGIN_VISP_NAMESPACE

//! Covariance of the pose's error in the frames in which it is asked for.
class vpPoseCovariance
{
public:
  //! \param chosen Motions that the user chose to be estimated.
  void update(const vpCueFusion &fusion, const vpHomogeneousMatrix &cMo, const vpModelLooks &looks,
              const vpMatrix &chosen);
  //! Of alpha, where exp(alpha) cMo is the true pose: camera frame, metres and radians.
  vpPoseMatrix6 ofMotion() const { return m_uncertainty.covariance(); }
  //! Of the error of the pose's translation and theta-u vector: the parameters of
  //! vpMatrix::computeCovarianceMatrixVVS(). Empty before the first one.
  vpMatrix ofParameters() const;
  //! The same as a part of the fusion alone knows it.
  vpMatrix ofParameters(const vpHomogeneousMatrix &cMo, std::size_t part) const;

private:
  vpPoseUncertainty m_uncertainty;
  std::optional<vpHomogeneousMatrix> m_cMo;
};

END_VISP_NAMESPACE
#endif
