// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchMotionFigures_h
#define benchMotionFigures_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>

#include <Eigen/Core>

#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {

//! Values of all frames in short; not a number where there is none.
struct Spread
{
  double mean = 0.;
  double tenth = 0.; //!< A tenth of the values is at most so large.
  double median = 0.;
  double ninth = 0.; //!< Nine tenths of the values are at most so large.
};

//! \param values In any order.
Spread spreadOf(std::vector<double> values);

//! How hard a sequence of poses is to follow.
struct MotionFigures
{
  Spread pixels;     //!< Mean motion of the model's points in the image from frame to frame.
  Spread degrees;    //!< Turn from frame to frame.
  Spread prediction; //!< How far off a prediction with constant velocity is, mean over the model's points, pixels.
};

/*!
  The prediction repeats the last frame's motion in the object's frame: with cpMo and cMo the last two poses, the next
  one is expected at cMo * (cpMo^-1 * cMo).
  \param poses cMo of frames that follow one another, metres.
  \param points Of the model, object frame, metres; about 500 of them, spread over the list, are used.
*/
MotionFigures measureMotion(const std::vector<vpHomogeneousMatrix> &poses, const std::vector<Eigen::Vector3d> &points,
                            const vpCameraParameters &cam);

} // namespace bench
#endif
