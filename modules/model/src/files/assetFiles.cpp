// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/assetFiles.h"

#include "files/meshSink.h"

#include <assimp/IOStream.hpp>
#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <cstdint>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
bool AssetFiles::Exists(const char *file) const
{
  return m_disk.Exists(file) || m_disk.Exists(percentDecoded(file).c_str());
}

Assimp::IOStream *AssetFiles::Open(const char *file, const char *mode)
{
  if (file != m_file) {
    return m_disk.Open(m_disk.Exists(file) ? file : percentDecoded(file).c_str(), mode);
  }
  auto *copy = new std::uint8_t[m_content.size()]; // The stream deletes it.
  std::copy(m_content.begin(), m_content.end(), copy);
  return new Assimp::MemoryIOStream(copy, m_content.size(), true);
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
