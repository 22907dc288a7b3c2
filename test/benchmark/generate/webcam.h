// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchWebcam_h
#define benchWebcam_h

#include "generate/motion.h"
#include "generate/shutter.h"

#include <opencv2/core.hpp>

#include <string>
#include <vector>

namespace bench {

/*!
  What a cheap camera in a room does to images: "rolling-shutter", "exposure" (motion blur), "drift" (of automatic
  exposure and white balance), "vignetting", "defocus", "noise" (of the sensor), "bayer" (one colour to a pixel, the
  others interpolated), "jpeg", and the room's light: "highlights" and "soft-shadows".
*/
std::vector<std::string> effectNames();

//! A camera with some of these effects.
class Webcam
{
public:
  //! \param effects Some of effectNames(). \param seed Of noise and drift.
  //! \throw vpException naming the effect that is not known.
  Webcam(const std::vector<std::string> &effects, const SceneCamera &camera, std::uint64_t seed);

  bool has(const std::string &effect) const;
  //! False where one instant is all of the image.
  bool hasShutter() const { return has("rolling-shutter") || has("exposure") || has("soft-shadows"); }
  Shutter shutter() const;

  //! What the sensor and its software make of the light of a frame. \param image 32-bit BGR, gray levels; changed.
  void process(int frame, cv::Mat &image) const;

private:
  void drift(int frame, cv::Mat &image) const;
  void addNoise(int frame, cv::Mat &image) const;

  std::vector<std::string> m_effects;
  SceneCamera m_camera;
  std::uint64_t m_seed;
  cv::Mat m_falloff; //!< Of brightness towards the corners, 32-bit BGR; empty without vignetting.
};

} // namespace bench
#endif
