// SPDX-License-Identifier: GPL-2.0-or-later
#include "check/checkedCamera.h"

#include <visp3/core/vpMath.h>

#include <algorithm>
#include <cmath>

namespace programs {
namespace {
// Of the whole width of the image, degrees: from a strong telephoto lens to a wide one without a fish eye.
constexpr double leastView = 3., mostView = 130.;
// How far from the middle of the image the principal point may be, as a share of the image's size.
constexpr double mostShift = 0.25;
// Ratio of both focal lengths of cameras whose pixels are not quite square.
constexpr double mostSkew = 1.2;
// The same of kud, where no lens that is not a fish eye has more.
constexpr double mostDistortion = 1.;
// Standard deviation of the brightness of an image that shows something, gray levels.
constexpr double leastContrast = 2.;

std::string sizeText(unsigned int width, unsigned int height)
{
  return std::to_string(width) + " x " + std::to_string(height);
}

bool saysCamera(const vpConfigReport &config)
{
  return std::any_of(config.taken.begin(), config.taken.end(),
                     [](const vpConfigReport::Item &item) { return item.setting.compare(0, 7, "camera.") == 0; });
}

// \return What is wrong; empty where nothing is.
std::string faultOf(const vpCameraParameters &cam, unsigned int width, unsigned int height)
{
  const double view = 2. * vpMath::deg(std::atan(0.5 * width / cam.get_px()));
  if (view < leastView || view > mostView) {
    return printed("it would see %.1f degrees across", view) + " an image of " + sizeText(width, height) +
           ": focal lengths are to be in pixels, and of this image size";
  }
  if (std::abs(cam.get_u0() / width - 0.5) > mostShift || std::abs(cam.get_v0() / height - 0.5) > mostShift) {
    return printed("its principal point (%.0f, ", cam.get_u0()) + printed("%.0f)", cam.get_v0()) +
           " is far from the middle of an image of " + sizeText(width, height) +
           ": the parameters are of another image size, or of a part of the image";
  }
  const double ratio = cam.get_px() / cam.get_py();
  if (std::max(ratio, 1. / ratio) > mostSkew) {
    return printed("px is %.2f times py", ratio) + ": check both, pixels are nearly square";
  }
  if (std::abs(cam.get_kud()) > mostDistortion) {
    return printed("kud is %g", cam.get_kud()) + ": it is for coordinates in metres at 1 m; undistort a fish eye first";
  }
  return "";
}
} // namespace

bool checkCamera(const vpCameraParameters &cam, const vpConfigReport &config, const vpImage<vpRGBa> &I,
                 CheckReport &report)
{
  const unsigned int width = I.getSize() > 0 ? I.getWidth() : config.imageWidth;
  const unsigned int height = I.getSize() > 0 ? I.getHeight() : config.imageHeight;
  report.say("camera", printed("px %.1f, ", cam.get_px()) + printed("py %.1f, ", cam.get_py()) +
                           printed("u0 %.1f, ", cam.get_u0()) + printed("v0 %.1f", cam.get_v0()) +
                           (cam.get_projModel() == vpCameraParameters::perspectiveProjWithDistortion
                                ? printed(", distortion kud %g", cam.get_kud())
                                : "") +
                           (width > 0 ? ", image " + sizeText(width, height) : ""));
  if (!saysCamera(config)) {
    report.blame("camera", "the configuration says no camera: give px, py, u0 and v0, or the file of a calibration");
    return false;
  }
  const bool isOtherSize = I.getSize() > 0 && config.imageWidth > 0 && config.imageHeight > 0 &&
                           (config.imageWidth != I.getWidth() || config.imageHeight != I.getHeight());
  const std::string fault = isOtherSize ? "its file is for images of " +
                                              sizeText(config.imageWidth, config.imageHeight) + ", and the image is " +
                                              sizeText(width, height) + ": scale the parameters, or the images"
                            : width > 0 ? faultOf(cam, width, height)
                                        : "";
  if (!fault.empty()) {
    report.blame("camera", fault);
  }
  return fault.empty();
}

void checkImage(const vpImage<vpRGBa> &I, CheckReport &report)
{
  double sum = 0., squares = 0.;
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    const double level = (I.bitmap[k].R + I.bitmap[k].G + I.bitmap[k].B) / 3.;
    sum += level;
    squares += level * level;
  }
  const double mean = sum / I.getSize();
  const double deviation = std::sqrt(std::max(0., squares / I.getSize() - mean * mean));
  report.say("image", sizeText(I.getWidth(), I.getHeight()) + printed(", mean brightness %.0f", mean) +
                          printed(", deviation %.0f of 255", deviation));
  if (deviation < leastContrast) {
    report.blame("image", printed("it shows nothing: all of it has brightness %.0f", mean) +
                              "; take one that shows the object, and check exposure and lens cap");
  }
}

} // namespace programs
