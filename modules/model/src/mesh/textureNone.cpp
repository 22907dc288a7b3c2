// SPDX-License-Identifier: GPL-2.0-or-later
#include "textureImage.h"

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
// Compiled where OpenCV's image codecs were not found: models then come without texture, and their report says so.
vpImage<vpRGBa> readTextureImage(const std::string &)
{
  return vpImage<vpRGBa>();
}

vpImage<vpRGBa> decodeTextureImage(const unsigned char *, std::size_t)
{
  return vpImage<vpRGBa>();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
