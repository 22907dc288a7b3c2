// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef assetFiles_h
#define assetFiles_h

#include <visp3/se3/vpCompatibility.h>

#include <assimp/DefaultIOSystem.h>
#include <assimp/IOStream.hpp>

#include <memory>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! The files that assimp opens. One of them is replaced, and names of the others may be percent-encoded.
class AssetFiles : public Assimp::IOSystem
{
public:
  //! \param content What assimp reads in place of \e file.
  AssetFiles(const std::string &file, const std::string &content) : m_file(file), m_content(content) {}

  bool Exists(const char *file) const override;
  char getOsSeparator() const override { return m_disk.getOsSeparator(); }
  Assimp::IOStream *Open(const char *file, const char *mode) override;
  void Close(Assimp::IOStream *stream) override { delete stream; }

private:
  std::unique_ptr<Assimp::IOStream> opened(const std::string &file, const char *mode);

  Assimp::DefaultIOSystem m_disk; // No base: from assimp 6 on it is final.
  std::string m_file;
  std::string m_content;
  // assimp closes or deletes what it is given; where a file is broken, some of its readers do neither.
  std::vector<std::unique_ptr<Assimp::IOStream>> m_open;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
