// SPDX-License-Identifier: GPL-2.0-or-later
#include "frames/pictureFile.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpWholeFile.h>

#include <opencv2/imgcodecs.hpp>

#include <filesystem>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

void writePicture(const std::string &file, const cv::Mat &picture)
{
  std::vector<unsigned char> bytes;
  if (!cv::haveImageWriter(file) || !cv::imencode(std::filesystem::path(file).extension().string(), picture, bytes)) {
    throw vpException(vpException::ioError, file + " cannot be written: OpenCV writes no images of this kind, use .png "
                                                   "or .jpg");
  }
  vpWholeFile::write(file, std::string(bytes.begin(), bytes.end()));
}

} // namespace programs
