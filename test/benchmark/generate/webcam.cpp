// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/webcam.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpPoseRandom.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {
// Frames: cameras of 640 x 480 and 30 frames a second take 28 to 31 ms from the first row to the last (Ringaby and
// Forssen 2012, measured on phones).
const double readout = 0.9;
// Frames: 1/60 s, what automatic exposure takes under lamps, which flicker at 100 or 120 Hz.
const double exposure = 0.5;
// Share of the brightness. A real webcam under even light changed by 6 % within 60 frames as a mug passed, and one
// colour against another by 3 %; a hand before a window does more.
const double brightnessDrift = 0.12;
const double colorDrift = 0.04;
// Assumed, for lenses of fixed focus: standard deviation of a Gaussian, pixels at 640 x 480.
const double defocus = 0.8;
// Assumed, for a small sensor in a room: standard deviation of black, and square of it per gray level, in all 1.5 to 5
// gray levels before the colours are interpolated.
const double darkNoise = 1.5;
const double photonNoise = 0.1;
// Assumed: images of 640 x 480 have 35 to 40 kB then, which USB 2 carries 30 times a second with ease.
const int jpegQuality = 75;
// Gray levels are a power of the light.
const double gamma = 2.2;

// Natural vignetting, the fourth power of the cosine.
cv::Mat falloff(const SceneCamera &camera)
{
  cv::Mat share(static_cast<int>(camera.height), static_cast<int>(camera.width), CV_32FC3);
  for (int i = 0; i < share.rows; ++i) {
    for (int j = 0; j < share.cols; ++j) {
      const double x = (j - camera.cam.get_u0()) / camera.cam.get_px();
      const double y = (i - camera.cam.get_v0()) / camera.cam.get_py();
      const double cosine = 1. / std::sqrt(1. + x * x + y * y);
      share.at<cv::Vec3f>(i, j) = cv::Vec3f::all(static_cast<float>(std::pow(cosine, 4. / gamma)));
    }
  }
  return share;
}

// Red and blue in every other row and column, green between them.
void demosaic(cv::Mat &image)
{
  cv::Mat colors;
  image.convertTo(colors, CV_8U);
  cv::Mat raw(colors.size(), CV_8U);
  for (int i = 0; i < raw.rows; ++i) {
    for (int j = 0; j < raw.cols; ++j) {
      const int channel = i % 2 != j % 2 ? 1 : (i % 2 == 0 ? 2 : 0);
      raw.at<uchar>(i, j) = colors.at<cv::Vec3b>(i, j)[channel];
    }
  }
  cv::cvtColor(raw, colors, cv::COLOR_BayerBG2BGR); // OpenCV calls it after the second row's second and third pixel.
  colors.convertTo(image, CV_32F);
}

void compress(cv::Mat &image)
{
  cv::Mat colors;
  image.convertTo(colors, CV_8U);
  std::vector<uchar> bytes;
  cv::imencode(".jpg", colors, bytes, {cv::IMWRITE_JPEG_QUALITY, jpegQuality});
  cv::imdecode(bytes, cv::IMREAD_COLOR).convertTo(image, CV_32F);
}
} // namespace

std::vector<std::string> effectNames()
{
  return {"rolling-shutter", "exposure", "drift", "vignetting", "defocus",
          "noise",           "bayer",    "jpeg",  "highlights", "soft-shadows"};
}

Webcam::Webcam(const std::vector<std::string> &effects, const SceneCamera &camera, std::uint64_t seed)
    : m_effects(effects), m_camera(camera), m_seed(seed)
{
  const std::vector<std::string> names = effectNames();
  for (const std::string &effect : effects) {
    if (std::find(names.begin(), names.end(), effect) == names.end()) {
      throw vpException(vpException::badValue, "there is no effect '%s'; --help lists them", effect.c_str());
    }
  }
  if (has("vignetting")) {
    m_falloff = falloff(camera);
  }
}

bool Webcam::has(const std::string &effect) const
{
  return std::find(m_effects.begin(), m_effects.end(), effect) != m_effects.end();
}

Shutter Webcam::shutter() const
{
  return {has("exposure") ? exposure : 0., has("rolling-shutter") ? readout : 0.};
}

void Webcam::process(int frame, cv::Mat &image) const
{
  if (has("defocus")) {
    cv::GaussianBlur(image, image, cv::Size(), defocus * m_camera.scale());
  }
  if (!m_falloff.empty()) {
    image = image.mul(m_falloff);
  }
  if (has("drift")) {
    drift(frame, image);
  }
  if (has("noise")) {
    addNoise(frame, image);
  }
  if (has("bayer")) {
    demosaic(image);
  }
  if (has("jpeg")) {
    compress(image);
  }
}

void Webcam::drift(int frame, cv::Mat &image) const
{
  vpPoseRandom random(m_seed, {0x6472696674});
  const auto wave = [&](double period) { return std::sin(2. * M_PI * (frame / period + random.uniform())); };
  const double brightness = 1. + brightnessDrift * (0.7 * wave(97.) + 0.3 * wave(41.));
  const double warmth = colorDrift * wave(173.);
  const double tint = 0.5 * colorDrift * wave(127.);
  cv::multiply(image, brightness * cv::Scalar(1. - warmth, 1. + tint, 1. + warmth), image);
}

void Webcam::addNoise(int frame, cv::Mat &image) const
{
  vpPoseRandom random(m_seed, {0x73656e736f72, static_cast<std::uint64_t>(frame)});
  cv::RNG numbers(random.index(std::uint64_t(1) << 62U));
  cv::Mat noise(image.size(), image.type());
  numbers.fill(noise, cv::RNG::NORMAL, 0., 1.);
  cv::Mat deviation;
  cv::sqrt(cv::max(image, 0.F) * photonNoise + cv::Scalar::all(darkNoise * darkNoise), deviation);
  image += noise.mul(deviation);
}

} // namespace bench
