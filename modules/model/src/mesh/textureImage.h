// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef textureImage_h
#define textureImage_h

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/se3/vpCompatibility.h>

#include <cstddef>
#include <string>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! \return The image in a file, empty if it cannot be read.
vpImage<vpRGBa> readTextureImage(const std::string &file);

//! \return The image in the bytes of a PNG or JPEG file, empty if it cannot be decoded.
vpImage<vpRGBa> decodeTextureImage(const unsigned char *bytes, std::size_t count);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
