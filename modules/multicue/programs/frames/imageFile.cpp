// SPDX-License-Identifier: GPL-2.0-or-later
#include "frames/imageFile.h"

#include <visp3/core/vpException.h>

#include <opencv2/imgcodecs.hpp>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {
namespace {
[[noreturn]] void fail(const std::string &text)
{
  throw vpException(vpException::ioError, text);
}

double largestValue(const cv::Mat &image)
{
  double largest = 0.;
  cv::minMaxLoc(image.reshape(1), nullptr, &largest);
  return largest;
}

int bitsFor(double largest)
{
  for (const int bits : {10, 12, 14}) {
    if (largest < static_cast<double>(1 << bits)) {
      return bits;
    }
  }
  return 16;
}
} // namespace

cv::Mat readColorImage(const std::string &file, ImageDepth &depth)
{
  cv::Mat image;
  try {
    image = cv::imread(file, cv::IMREAD_COLOR | cv::IMREAD_ANYDEPTH | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception &e) {
    fail("'" + file + "' cannot be read: " + e.what());
  }
  if (image.empty()) {
    fail("'" + file + "' is missing or no image that can be read");
  }
  if (image.depth() == CV_8U) {
    return image;
  }
  if (image.depth() != CV_16U) {
    fail("'" + file + "' has pixels that are no whole numbers of 8 or 16 bits: convert it to an image of 8 bits");
  }
  // Cameras of 12 bits leave the upper four empty: what OpenCV makes 8 bits of would be nearly black.
  const double largest = largestValue(image);
  depth.bits = depth.bits == 0 ? bitsFor(largest) : depth.bits;
  if (bitsFor(largest) > depth.bits) {
    fail("'" + file + "' has values up to " + std::to_string(static_cast<int>(largest)) + ", the images before " +
         std::to_string(depth.bits) + " bits: convert all of them to 8 bits");
  }
  cv::Mat result;
  image.convertTo(result, CV_8U, 255. / static_cast<double>((1 << depth.bits) - 1));
  return result;
}

cv::Mat readColorImage(const std::string &file)
{
  ImageDepth depth;
  try {
    return readColorImage(file, depth);
  } catch (const vpException &) {
    return cv::Mat();
  }
}

} // namespace programs
