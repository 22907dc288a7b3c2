// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef assetFiles_h
#define assetFiles_h

#include <visp3/se3/vpCompatibility.h>

#include <assimp/DefaultIOSystem.h>

#include <string>

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
  void Close(Assimp::IOStream *stream) override { m_disk.Close(stream); }

private:
  Assimp::DefaultIOSystem m_disk; // No base: from assimp 6 on it is final.
  std::string m_file;
  std::string m_content;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
