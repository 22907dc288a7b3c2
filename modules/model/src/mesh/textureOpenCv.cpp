// SPDX-License-Identifier: GPL-2.0-or-later
#include "textureImage.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <fstream>
#include <iterator>
#include <limits>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
vpImage<vpRGBa> readTextureImage(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  return decodeTextureImage(reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size());
}

vpImage<vpRGBa> decodeTextureImage(const unsigned char *bytes, std::size_t count)
{
  if (count == 0 || count > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return vpImage<vpRGBa>();
  }
  cv::Mat decoded;
  try {
    const std::vector<unsigned char> buffer(bytes, bytes + count);
    decoded = cv::imdecode(buffer, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception &) {
    // Broken bytes and images too large for memory: the caller reports that there is no image.
    return vpImage<vpRGBa>();
  }
  vpImage<vpRGBa> image(static_cast<unsigned int>(decoded.rows), static_cast<unsigned int>(decoded.cols));
  for (int i = 0; i < decoded.rows; ++i) {
    vpRGBa *const row = image[static_cast<unsigned int>(i)];
    for (int j = 0; j < decoded.cols; ++j) {
      const cv::Vec3b &pixel = decoded.at<cv::Vec3b>(i, j);
      row[j] = vpRGBa(pixel[2], pixel[1], pixel[0], 255);
    }
  }
  return image;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
