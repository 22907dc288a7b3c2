// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchLight_h
#define benchLight_h

#include "generate/shadowMap.h"
#include "generate/syntheticObject.h"

namespace bench {

//! A far light and what is everywhere; camera frame, so that the light stays while the object moves.
struct Light
{
  Eigen::Vector3d toLight = Eigen::Vector3d(-0.45, -0.6, -0.8).normalized(); //!< Unit vector.
  float diffuse = 0.80F;
  float ambient = 0.36F;
  float gain = 1.F;     //!< Multiplies what is seen.
  float contrast = 1.F; //!< Spread of the seen colours about middle gray.
};

/*!
  The light of a frame.
  \param moves Whether direction, brightness and contrast change with time.
  \param time In frames.
  \param seed The same one gives the same light.
*/
Light lightAt(const SyntheticObject &object, bool moves, double time, std::uint64_t seed);

/*!
  A light of some extent, seen at many instants, makes soft shadows.
  \param instant Counts them; a few that follow one another are spread over the whole light.
  \return \e light from another point of a lamp.
*/
Light lampPoint(const Light &light, int instant);

//! A surface point that is to be shaded.
struct SurfacePoint
{
  Eigen::Vector3f camera; //!< Place, camera frame, metres.
  Eigen::Vector3f object; //!< Place, object frame, metres.
  Eigen::Vector3f normal; //!< Unit normal, camera frame, towards the camera.
  Eigen::Vector3f color;  //!< Blue, green, red, gray levels.
};

/*!
  Lambert's law with a highlight and ambient light.
  \param shadow What the light sees.
  \param oRc Rotation from camera to object frame.
  \return Blue, green, red in gray levels, [0, 255].
*/
Eigen::Vector3f shade(const SurfacePoint &point, const SurfaceMaterial &material, const Light &light,
                      const ShadowMap &shadow, const Eigen::Matrix3f &oRc);

} // namespace bench
#endif
