// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMotionFrame_h
#define vpMotionFrame_h

#include <visp3/core/vpMatrix.h>
#include <visp3/se3/vpPoseExponential.h>

BEGIN_VISP_NAMESPACE

/*!
  Small motions in which an object's size and distance do not matter: in the object's frame, all in metres, a rotation
  as the path of a point at half the diameter.
*/
class vpMotionFrame
{
public:
  //! Motions with less information than this share of the best known one are not estimated.
  static constexpr double leastInformation = 1e-8;

  static vpPoseMatrix6 toEigen(const vpMatrix &M)
  {
    return Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(M.data);
  }

  //! From such a motion to metres and radians, its diagonal. \param diameter Of the object, metres.
  static vpPoseTangent scale(double diameter)
  {
    vpPoseTangent scale;
    scale << 1., 1., 1., 2. / diameter, 2. / diameter, 2. / diameter;
    return scale;
  }
};

END_VISP_NAMESPACE
#endif
