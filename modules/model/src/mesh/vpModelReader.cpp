// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpModelReader.h>

#include "meshImport.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

BEGIN_VISP_NAMESPACE
namespace {
const std::array<const char *, 6> meshExtensions = {{".obj", ".ply", ".stl", ".dae", ".gltf", ".glb"}};

[[noreturn]] void refuseFile(const std::string &file, const std::string &reason)
{
  throw vpException(vpException::ioError, "%s", ("model '" + file + "' " + reason).c_str());
}

bool hasExtension(const std::string &file, const std::string &extension)
{
  std::string lower = std::filesystem::path(file).extension().string();
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == extension;
}

// assimp 5.2 looks for the line that ends the header for ever where a file was cut off before it.
void checkPlyHeader(const std::string &file)
{
  constexpr std::size_t longestHeader = 1U << 20U;
  std::string start(longestHeader, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(&start[0], static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  if (start.find("end_header\n") == std::string::npos && start.find("end_header\r") == std::string::npos) {
    refuseFile(file, "has no complete header, is it broken or of another format?");
  }
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
  if (hasExtension(file, ".ply")) {
    checkPlyHeader(file);
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
