// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchCheckedGeometry_h
#define benchCheckedGeometry_h

#include "dataset/sequence.h"

/*!
  \file checkedGeometry.h
  Poses, cameras and sizes made of a file's numbers. All throw a vpException that starts with \e place, the file and
  where in it the numbers stand.
*/

namespace bench {

/*!
  \param rotation Nine numbers, row by row: orthonormal within 1e-3 with determinant 1; the nearest rotation is taken.
  \param translation Metres.
*/
vpHomogeneousMatrix checkedTransform(const std::vector<double> &rotation, const Eigen::Vector3d &translation,
                                     const std::string &place);

//! A transform of 16 numbers, row by row, whose last row has to be 0 0 0 1. \param unit Metres per unit of length.
vpHomogeneousMatrix checkedTransform(const std::vector<double> &matrix, double unit, const std::string &place);

//! \throw vpException where the object's origin is not in front of the camera.
void requireInFront(const vpHomogeneousMatrix &cMo, const std::string &place);

//! A camera without distortion, pixel centres at integers. \throw vpException where a focal length is not positive.
vpCameraParameters checkedCamera(double px, double py, double u0, double v0, const std::string &place);

//! Largest distance of two vertices of the object's mesh, or of its .cao where there is no mesh; metres.
//! \throw vpException naming the file where it cannot be read.
double measuredDiameter(const SequenceObject &object);

//! Leaves out the frames before the first one with truth: a tracker has to start somewhere.
//! \throw vpException where less than two frames are left. \param place What was read.
void startAtFirstTruth(std::vector<SequenceFrame> &frames, const std::string &place);

} // namespace bench
#endif
