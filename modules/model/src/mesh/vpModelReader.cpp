// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpModelReader.h>

#include "files/fileBytes.h"
#include "meshImport.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>

BEGIN_VISP_NAMESPACE
using vpMeshDetail::refuseFile;

namespace {
const std::array<const char *, 6> meshExtensions = {{".obj", ".ply", ".stl", ".dae", ".gltf", ".glb"}};

bool hasExtension(const std::string &file, const std::string &extension)
{
  std::string lower = std::filesystem::path(file).extension().string();
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == extension;
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
  return std::any_of(meshExtensions.begin(), meshExtensions.end(),
                     [&](const char *extension) { return hasExtension(file, extension); });
}

vpTrackedModel vpModelReader::read(const std::string &file, const vpModelOptions &options,
                                   const vpHomogeneousMatrix &oMm)
{
  vpTrackedModelBuilder builder(options);
  addTo(builder, file, options.unit, oMm);
  return builder.build(file);
}

void vpModelReader::addTo(vpTrackedModelBuilder &builder, const std::string &file, double unit,
                          const vpHomogeneousMatrix &oMm)
{
  checkFile(file);
  vpTrackedModelBuilder changed = builder;
  vpMeshDetail::importMesh(file, unit, oMm, changed);
  builder = std::move(changed);
}
END_VISP_NAMESPACE
