// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseImageDeviation_h
#define vpPoseImageDeviation_h

#include <visp3/se3/vpPoseExponential.h>

#include <visp3/core/vpCameraParameters.h>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \class vpPoseImageDeviation
  \ingroup group_se3
  \brief How far points may be from where an uncertain pose projects them, to first order: what a search range is made
  of.
*/
class VISP_EXPORT vpPoseImageDeviation
{
public:
  /*!
    \param cam Camera without distortion (distortion coefficients are ignored).
    \param cMo The pose.
    \param covariance Of alpha, where exp(alpha) cMo is the true pose: [v, omega] in the camera's frame, metres and
    radians, as vpPoseKalmanFilter::predict() gives it.
    \param oX A point, object frame, metres.
    \return Covariance of the point's projection (u, v), square pixels; 0 where the point is not before the camera.
  */
  static Eigen::Matrix2d covariance(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo,
                                    const vpPoseMatrix6 &covariance, const Eigen::Vector3d &oX);

  /*!
    \param cam, cMo, covariance See above.
    \param oX Points, object frame, metres.
    \return The largest standard deviation of a projection, in any direction, of any of the points, pixels; 0 where no
    point is before the camera.
  */
  static double largest(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &covariance,
                        const std::vector<Eigen::Vector3d> &oX);

  /*!
    \param cam, cMo, covariance, oX See above.
    \param normal A direction in the image (u, v), of unit length.
    \return The standard deviation of the projection along \e normal, pixels: what an edge of that normal may be off by.
  */
  static double along(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &covariance,
                      const Eigen::Vector3d &oX, const Eigen::Vector2d &normal);
};

END_VISP_NAMESPACE

#endif
