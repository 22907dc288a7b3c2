// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchBackground_h
#define benchBackground_h

#include "generate/motion.h"

#include <opencv2/core.hpp>

#include <string>

namespace bench {

//! What is behind the object: a picture that slowly pans and zooms.
class Background
{
public:
  /*!
    \param kind "photo", "wall", "plain" or "space".
    \param seed Chooses the picture and how it moves.
    \throw vpException where there is no such kind, or the photographs are missing.
  */
  Background(const std::string &kind, const SceneCamera &camera, std::uint64_t seed);

  //! \param time In frames. \param turn Of the camera: what is seen in direction d without it, is seen in turn * d.
  //! \return The image: blue, green, red, gray levels, 32-bit floats.
  cv::Mat at(double time, const Eigen::Matrix3d &turn) const;

private:
  SceneCamera m_camera;
  cv::Mat m_picture; //!< 8-bit BGR, empty for a plain background.
  std::uint64_t m_seed = 1;
};

/*!
  A photograph of ViSP's data set, found as ViSP finds it: in the folder that VISP_INPUT_IMAGE_PATH names, or where
  packages put it.
  \param which Chooses one of those that are there. Gray ones are tinted.
  \throw vpException where there is none, telling how to get them.
*/
cv::Mat openPhoto(std::uint64_t which);

//! A plastered wall with posters on it: clutter that needs no file. 8-bit BGR.
cv::Mat drawWall(int width, int height, std::uint64_t seed);

//! Stars on black, and a part of the Earth with clouds. 8-bit BGR.
cv::Mat drawSpace(int width, int height, std::uint64_t seed);

} // namespace bench
#endif
