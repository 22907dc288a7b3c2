// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzMesh.cpp Fuzzes the readers of meshes: the first byte chooses the format.
#include "fuzzFile.h"

#include <visp3/model/vpModelReader.h>

#include <array>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  static const std::array<const char *, 6> endings = {{"obj", "ply", "stl", "dae", "gltf", "glb"}};
  if (size == 0) {
    return 0;
  }
  const std::string name = std::string("mesh.") + endings[data[0] % endings.size()];
  return fuzz::readFile(name, data + 1, size - 1, [](const std::string &file) { vpModelReader::read(file); });
}
