// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef sceneCheck_h
#define sceneCheck_h

#include "files/meshSink.h"

#include <cstddef>
#include <string>
#include <vector>

/*!
  \file sceneCheck.h
  Looks at scene files before assimp does, which recurses and allocates as deep and as much as they say, makes up what
  is missing, and leaves out what it does not know.
*/

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! What a file of a scene holds.
struct SceneCheck
{
  std::size_t polygons = 0; //!< Of all instances of all meshes, lines and points not counted.
  //! That it has: those beyond are made up by assimp.
  std::size_t materials = 0;
  std::vector<std::string> warnings; //!< What will not be as in the file.
  std::string content;               //!< The file without what is of no use here, for assimp to read.
};

//! A .gltf or .glb file. \throw vpException naming the file and what is wrong in it.
SceneCheck checkGltf(const std::string &file);

//! How often nodes may be visited, and how deep, with every instance of a node counted.
constexpr std::size_t mostNodes = 100000;
constexpr std::size_t deepestNode = 200;
//! Polygons of all instances.
constexpr std::size_t mostPolygons = MeshSink::mostTriangles;
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
