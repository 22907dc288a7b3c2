// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseExponential_h
#define vpPoseExponential_h

#include <visp3/se3/vpCompatibility.h>

#include <visp3/core/vpHomogeneousMatrix.h>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE

/*!
  Exponential coordinates of a pose, an element of se(3) in ViSP's order: translation part v (metres), then rotation
  part omega (radians).
  \ingroup group_se3
*/
using vpPoseTangent = Eigen::Matrix<double, 6, 1>;

/*!
  A 6x6 matrix on exponential coordinates, such as a covariance (m^2, m rad, rad^2) or an adjoint.
  \ingroup group_se3
*/
using vpPoseMatrix6 = Eigen::Matrix<double, 6, 6>;

/*!
  \class vpPoseExponential
  \ingroup group_se3
  \brief Exponential map, logarithm and adjoint of SE(3), and the way between ViSP's and Eigen's types.

  exp() is vpExponentialMap::direct(). log() replaces vpExponentialMap::inverse(), which takes square roots of rounding
  errors where the rotation is near pi and loses half of the digits there.
*/
class VISP_EXPORT vpPoseExponential
{
public:
  /*!
    \param xi Exponential coordinates [v, omega], metres and radians.
    \return The displacement exp(xi), as vpExponentialMap::direct() gives it.
  */
  static vpHomogeneousMatrix exp(const vpPoseTangent &xi);

  //! The same as a pose of Eigen's, without memory to allocate; equal to exp() up to rounding.
  static Eigen::Isometry3d expEigen(const vpPoseTangent &xi);

  /*!
    The inverse of exp(), accurate for every angle from 0 to pi. At pi the axis has two signs, and one of them is
    returned.

    \param aMb A pose.
    \return Exponential coordinates [v, omega] with |omega| <= pi, metres and radians.
  */
  static vpPoseTangent log(const vpHomogeneousMatrix &aMb);

  //! The same for a pose of Eigen's, without memory to allocate.
  static vpPoseTangent log(const Eigen::Isometry3d &aMb);

  /*!
    The same for a rotation as a quaternion, without trigonometry below 0.2 rad: mixtures ask for all pairs of two sets.

    \param aRb The rotation, a quaternion of unit length and either sign.
    \param atb The translation, metres.
  */
  static vpPoseTangent log(const Eigen::Quaterniond &aRb, const Eigen::Vector3d &atb);

  /*!
    \param aMb A pose.
    \return The matrix that takes a tangent from frame b to frame a: aMb exp(xi) = exp(adjoint(aMb) xi) aMb. It is
    vpVelocityTwistMatrix of aMb.
  */
  static vpPoseMatrix6 adjoint(const vpHomogeneousMatrix &aMb);

  /*!
    How exp() changes volumes: the logarithm of |d exp / d xi|, from Lebesgue's measure on the coordinates to the
    invariant measure of SE(3). Only the rotation matters: with angle theta it is 2 log(2 (1 - cos(theta)) / theta^2).

    \param xi Exponential coordinates [v, omega] with |omega| < 2 pi.
    \return The logarithm, 0 at xi = 0 and falling to 2 log(4 / pi^2) = -1.81 at half a turn.
  */
  static double logVolume(const vpPoseTangent &xi);

  /*!
    \param aMb A pose of ViSP.
    \return The same pose as Eigen's type. Needs no Eigen in ViSP itself, unlike vp::visp2eigen().
  */
  static Eigen::Isometry3d toEigen(const vpHomogeneousMatrix &aMb);

  /*!
    \param aMb A pose of Eigen, whose linear part has to be a rotation.
    \return The same pose as ViSP's type.
    \throw vpException::badValue if the linear part is not a rotation.
  */
  static vpHomogeneousMatrix fromEigen(const Eigen::Isometry3d &aMb);
};

END_VISP_NAMESPACE

#endif
