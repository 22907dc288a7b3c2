// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpModelReader.h>

#include "meshImport.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <system_error>

BEGIN_VISP_NAMESPACE
namespace {
const std::array<const char *, 6> meshExtensions = {{".obj", ".ply", ".stl", ".dae", ".gltf", ".glb"}};

[[noreturn]] void refuseFile(const std::string &file, const std::string &reason)
{
  throw vpException(vpException::ioError, "%s", ("model '" + file + "' " + reason).c_str());
}

void checkFile(const std::string &file)
{
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    refuseFile(file, "does not exist");
  }
  if (!std::filesystem::is_regular_file(file, error)) {
    refuseFile(file, "is not a file");
  }
  if (std::filesystem::file_size(file, error) == 0) {
    refuseFile(file, "is empty");
  }
  if (!vpModelReader::isMesh(file)) {
    refuseFile(file, "is not a mesh that can be read: .obj, .ply, .stl, .dae, .gltf and .glb are");
  }
}
} // namespace

bool vpModelReader::isMesh(const std::string &file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(meshExtensions.begin(), meshExtensions.end(), extension) != meshExtensions.end();
}

vpTrackedModel vpModelReader::read(const std::string &file, const vpModelOptions &options,
                                   const vpHomogeneousMatrix &oMm)
{
  vpTrackedModelBuilder builder(options);
  checkFile(file);
  vpMeshDetail::importMesh(file, options.unit, oMm, builder);
  return builder.build(file);
}
END_VISP_NAMESPACE
