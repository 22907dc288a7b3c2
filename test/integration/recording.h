// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef recording_h
#define recording_h

#include <visp3/core/vpException.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpIoTools.h>
#include <visp3/core/vpMath.h>
#include <visp3/io/vpImageIo.h>
#include <visp3/se3/vpCompatibility.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

//! The sequences of ViSP's data set that the tests track.
namespace recording {
//! A path in ViSP's data set. \throw vpException saying how to get it, because without it a test proves nothing.
inline std::string path(const std::string &name)
{
  const std::string file = vpIoTools::createFilePath(vpIoTools::getViSPImagesDataPath(), name);
  if (!vpIoTools::checkFilename(file)) {
    throw vpException(
        vpException::ioError,
        "'%s' was not found: install ViSP's data set (Debian: visp-images-data) or set VISP_INPUT_IMAGE_PATH",
        file.c_str());
  }
  return file;
}

inline std::string numbered(const std::string &pattern, int frame)
{
  char name[64];
  std::snprintf(name, sizeof(name), pattern.c_str(), frame);
  return name;
}

//! \param pattern Without the type: images are .pgm up to ViSP 3.5 and .png later.
inline vpImage<unsigned char> image(const std::string &pattern, int frame)
{
  const std::string name = vpIoTools::createFilePath(vpIoTools::getViSPImagesDataPath(), numbered(pattern, frame));
  vpImage<unsigned char> I;
  vpImageIo::read(I, vpIoTools::checkFilename(name + ".png") ? name + ".png" : path(numbered(pattern, frame) + ".pgm"));
  return I;
}

inline vpHomogeneousMatrix pose(const std::string &pattern, int frame)
{
  std::ifstream file(path(numbered(pattern, frame)));
  vpHomogeneousMatrix cMo;
  for (unsigned int i = 0; i < 16; ++i) {
    file >> cMo.data[i];
  }
  if (!file) {
    throw vpException(vpException::ioError, "The pose of frame %d cannot be read", frame);
  }
  return cMo;
}

inline double median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

inline double maximum(const std::vector<double> &values)
{
  return *std::max_element(values.begin(), values.end());
}
} // namespace recording

END_VISP_NAMESPACE
#endif
