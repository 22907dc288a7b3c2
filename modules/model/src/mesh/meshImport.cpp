// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshImport.h"

#include "files/assetFiles.h"
#include "files/fileBytes.h"
#include "files/meshFormats.h"
#include "files/sceneCheck.h"
#include "textureImage.h"

#include <visp3/core/vpException.h>

#include <Eigen/Geometry>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <filesystem>
#include <map>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
Eigen::Affine3d toEigen(const aiMatrix4x4 &m)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  result.matrix().topRows<3>() << static_cast<double>(m.a1), static_cast<double>(m.a2), static_cast<double>(m.a3),
      static_cast<double>(m.a4), static_cast<double>(m.b1), static_cast<double>(m.b2), static_cast<double>(m.b3),
      static_cast<double>(m.b4), static_cast<double>(m.c1), static_cast<double>(m.c2), static_cast<double>(m.c3),
      static_cast<double>(m.c4);
  return result;
}

Eigen::Vector3f toEigen(const aiColor4D &color)
{
  return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
}

//! What all triangles of an assimp mesh have in common.
struct Material
{
  Eigen::Vector3f color = vpTrackedModelBuilder::Corner().color;
  int image = -1;
};

//! Walks through the nodes of a scene and hands its triangles to the builder.
class SceneReader
{
public:
  //! \param materials How many the file has; assimp appends one of its own for what has none.
  SceneReader(const aiScene &scene, std::size_t materials, MeshSink &sink)
      : m_scene(scene), m_materials(materials), m_sink(sink)
  {
  }

  void addNode(const aiNode &node, const Eigen::Affine3d &objectFromParent)
  {
    const Eigen::Affine3d objectFromNode = objectFromParent * toEigen(node.mTransformation);
    for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
      addMesh(*m_scene.mMeshes[node.mMeshes[i]], objectFromNode);
    }
    for (unsigned int i = 0; i < node.mNumChildren; ++i) {
      addNode(*node.mChildren[i], objectFromNode);
    }
  }

private:
  void addMesh(const aiMesh &mesh, const Eigen::Affine3d &objectFromMesh)
  {
    const Material material = materialOf(mesh);
    const bool mirrored = objectFromMesh.linear().determinant() < 0.;
    for (unsigned int f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace &face = mesh.mFaces[f];
      // Points and lines are no surface.
      if (face.mNumIndices != 3) {
        continue;
      }
      std::array<vpTrackedModelBuilder::Corner, 3> corners;
      for (unsigned int k = 0; k < 3; ++k) {
        corners[k] = cornerOf(mesh, face.mIndices[mirrored ? 2 - k : k], material);
        corners[k].position = objectFromMesh * corners[k].position;
      }
      m_sink.addTriangle(corners, material.image);
    }
  }

  static vpTrackedModelBuilder::Corner cornerOf(const aiMesh &mesh, unsigned int vertex, const Material &material)
  {
    vpTrackedModelBuilder::Corner corner;
    const aiVector3D &position = mesh.mVertices[vertex];
    corner.position << static_cast<double>(position.x), static_cast<double>(position.y),
        static_cast<double>(position.z);
    corner.color = material.color;
    if (mesh.HasVertexColors(0)) {
      corner.color = toEigen(mesh.mColors[0][vertex]);
    }
    if (material.image >= 0) {
      // The importers give v upwards, whatever the file has.
      const aiVector3D &uv = mesh.mTextureCoords[0][vertex];
      corner.texture << static_cast<float>(uv.x), 1.F - static_cast<float>(uv.y);
    }
    return corner;
  }

  Material materialOf(const aiMesh &mesh)
  {
    Material result;
    if (mesh.mMaterialIndex >= m_materials) {
      return result;
    }
    const aiMaterial &material = *m_scene.mMaterials[mesh.mMaterialIndex];
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    aiColor4D color;
    // What assimp makes up where a file has no materials says nothing about the object.
    if (std::string(name.C_Str()) != AI_DEFAULT_MATERIAL_NAME &&
        material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS) {
      result.color = toEigen(color);
    }
    aiString path;
    if (mesh.HasTextureCoords(0) && material.GetTexture(aiTextureType_DIFFUSE, 0, &path) == AI_SUCCESS) {
      result.image = imageAt(path.C_Str());
    }
    return result;
  }

  int imageAt(const std::string &path)
  {
    const aiTexture *embedded = m_scene.GetEmbeddedTexture(path.c_str());
    if (embedded == nullptr) {
      return m_sink.imageAt(path);
    }
    const auto known = m_embedded.find(path);
    if (known != m_embedded.end()) {
      return known->second;
    }
    const int index = m_sink.addImage(path, decodeEmbedded(*embedded));
    m_embedded.emplace(path, index);
    return index;
  }

  static vpImage<vpRGBa> decodeEmbedded(const aiTexture &texture)
  {
    if (texture.mHeight == 0) {
      return decodeTextureImage(reinterpret_cast<const unsigned char *>(texture.pcData), texture.mWidth);
    }
    vpImage<vpRGBa> image(texture.mHeight, texture.mWidth);
    for (unsigned int i = 0; i < image.getSize(); ++i) {
      const aiTexel &texel = texture.pcData[i];
      image.bitmap[i] = vpRGBa(texel.r, texel.g, texel.b, texel.a);
    }
    return image;
  }

  const aiScene &m_scene;
  std::size_t m_materials;
  MeshSink &m_sink;
  std::map<std::string, int> m_embedded;
};

//! Polygons of all instances of meshes below a node; the file was checked not to be nested too deep.
std::size_t countPolygons(const aiScene &scene, const aiNode &node)
{
  std::size_t count = 0;
  for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh &mesh = *scene.mMeshes[node.mMeshes[i]];
    count += static_cast<std::size_t>(std::count_if(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                                                    [](const aiFace &face) { return face.mNumIndices >= 3; }));
  }
  for (unsigned int i = 0; i < node.mNumChildren; ++i) {
    count += countPolygons(scene, *node.mChildren[i]);
  }
  return count;
}

[[noreturn]] void refuseUnreadable(const std::string &file, const std::string &reason)
{
  throw vpException(vpException::ioError,
                    "model '" + file + "' cannot be read, is it broken or of another format? " + reason);
}

//! assimp keeps coordinates as 32-bit floats. \throw vpException where too little of the shape is left.
void checkDigits(const aiScene &scene, MeshSink &sink)
{
  for (unsigned int m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh &mesh = *scene.mMeshes[m];
    Eigen::AlignedBox3f box;
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v) {
      box.extend(Eigen::Vector3f(mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z));
    }
    const float farthest = box.isEmpty() ? 0.F : box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
    const float share = farthest > 0.F ? box.diagonal().norm() / farthest : 1.F;
    if (share < 1e-5F) {
      refuseFile(sink.file(),
                 "lies so far from its origin, for its size, that 32-bit floats lose its shape: move it to "
                 "the origin");
    }
    if (share < 1e-3F) {
      sink.builder().addWarning("it lies far from its origin, for its size: 32-bit floats lose some of its digits");
    }
  }
}

void importScene(MeshSink &sink)
{
  const std::string &file = sink.file();
  const SceneCheck check = checkGltf(file);
  Assimp::Importer importer;
  importer.SetIOHandler(new AssetFiles(file, check.content)); // The importer deletes it.
  // What has no mesh would get one made up for its nodes.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene *scene = importer.ReadFile(file, 0);
  if (scene == nullptr && check.polygons > 0) {
    refuseUnreadable(file, importer.GetErrorString());
  }
  const std::size_t read =
      scene == nullptr || scene->mRootNode == nullptr ? 0 : countPolygons(*scene, *scene->mRootNode);
  if (check.polygons == 0 && read == 0) {
    sink.requireTriangles();
  }
  if (read != check.polygons) {
    refuseUnreadable(file, "It has " + std::to_string(check.polygons) + " polygons, of which " + std::to_string(read) +
                               " came out");
  }
  // Validation comes first and finds indices out of range, which not all importers look for.
  scene = importer.ApplyPostProcessing(aiProcess_ValidateDataStructure | aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    refuseUnreadable(file, importer.GetErrorString());
  }
  checkDigits(*scene, sink);
  SceneReader(*scene, check.materials, sink).addNode(*scene->mRootNode, sink.placement());
  for (const std::string &warning : check.warnings) {
    sink.builder().addWarning(warning);
  }
}
} // namespace

void importMesh(const std::string &file, double unit, const vpHomogeneousMatrix &oMm, vpTrackedModelBuilder &builder)
{
  MeshSink sink(file, unit, oMm, builder);
  const std::string extension = lowerCase(std::filesystem::path(file).extension().string());
  if (extension == ".obj") {
    readObj(sink);
  } else if (extension == ".ply") {
    readPly(sink);
  } else if (extension == ".stl") {
    readStl(sink);
  } else if (extension == ".dae") {
    readDae(sink);
  } else {
    importScene(sink);
  }
  sink.requireTriangles();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
