// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/assetFiles.h"

#include "files/meshSink.h"

#include <assimp/IOStream.hpp>
#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <cstdint>
#include <utility>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
//! A stream that another one owns, and that may be lost: it is used as long as that one is there.
class LentStream : public Assimp::IOStream
{
public:
  explicit LentStream(Assimp::IOStream &stream) : m_stream(stream) {}

  std::size_t Read(void *buffer, std::size_t size, std::size_t count) override
  {
    return m_stream.Read(buffer, size, count);
  }
  std::size_t Write(const void *buffer, std::size_t size, std::size_t count) override
  {
    return m_stream.Write(buffer, size, count);
  }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override { return m_stream.Seek(offset, origin); }
  std::size_t Tell() const override { return m_stream.Tell(); }
  std::size_t FileSize() const override { return m_stream.FileSize(); }
  void Flush() override { m_stream.Flush(); }

private:
  Assimp::IOStream &m_stream;
};
} // namespace

bool AssetFiles::Exists(const char *file) const
{
  return m_disk.Exists(file) || m_disk.Exists(percentDecoded(file).c_str());
}

std::unique_ptr<Assimp::IOStream> AssetFiles::opened(const std::string &file, const char *mode)
{
  if (file != m_file) {
    return std::unique_ptr<Assimp::IOStream>(
        m_disk.Open(m_disk.Exists(file.c_str()) ? file.c_str() : percentDecoded(file).c_str(), mode));
  }
  auto *copy = new std::uint8_t[m_content.size()]; // The stream deletes it.
  std::copy(m_content.begin(), m_content.end(), copy);
  return std::make_unique<Assimp::MemoryIOStream>(copy, m_content.size(), true);
}

Assimp::IOStream *AssetFiles::Open(const char *file, const char *mode)
{
  std::unique_ptr<Assimp::IOStream> stream = opened(file, mode);
  if (!stream) {
    return nullptr;
  }
  m_open.push_back(std::move(stream));
  return new LentStream(*m_open.back());
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
