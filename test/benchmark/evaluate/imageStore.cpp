// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/imageStore.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>

#include <opencv2/imgcodecs.hpp>

namespace bench {

namespace {
const std::size_t mostBytes = std::size_t(1) << 30;
} // namespace

const cv::Mat &ImageStore::decoded(std::size_t index)
{
  const auto known = m_images.find(index);
  if (known != m_images.end()) {
    return known->second;
  }
  const std::string &file = m_sequence.frames[index].image;
  m_last = programs::readColorImage(file, m_depth);
  if (m_size.empty()) {
    m_size = m_last.size();
  }
  if (m_last.size() != m_size) {
    throw vpException(vpException::dimensionError, "'%s' is %d x %d, the images before it %d x %d", file.c_str(),
                      m_last.cols, m_last.rows, m_size.width, m_size.height);
  }
  const std::size_t bytes = m_last.total() * m_last.elemSize();
  if (m_bytes + bytes > mostBytes) {
    return m_last;
  }
  m_bytes += bytes;
  return m_images.emplace(index, m_last.clone()).first->second;
}

void ImageStore::get(std::size_t index, BenchImage &I)
{
  const cv::Mat &image = decoded(index);
  vpImageConvert::convert(image, I.color);
  vpImageConvert::convert(image, I.gray);
}

} // namespace bench
