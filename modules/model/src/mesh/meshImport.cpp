// SPDX-License-Identifier: GPL-2.0-or-later
#include "meshImport.h"

#include "textureImage.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>

#include <Eigen/Geometry>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
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

//! From the file's coordinates to those of the builder.
Eigen::Affine3d toBuilder(const vpHomogeneousMatrix &oMm, double unit, double builderUnit)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      result.matrix()(i, j) = oMm[i][j] * (unit / builderUnit);
    }
    result.matrix()(i, 3) = oMm[i][3] / builderUnit;
  }
  return result;
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
  SceneReader(const aiScene &scene, const std::string &folder, vpTrackedModelBuilder &builder)
      : m_scene(scene), m_folder(folder), m_builder(builder)
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

  bool hasTriangles() const { return m_hasTriangles; }

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
      if (material.image >= 0) {
        moveToFirstRepeat(corners);
      }
      m_builder.addTriangle(corners, material.image);
      m_hasTriangles = true;
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
      const aiColor4D &color = mesh.mColors[0][vertex];
      corner.color << color.r, color.g, color.b;
    }
    if (material.image >= 0) {
      // The importers give v upwards, whatever the file has.
      const aiVector3D &uv = mesh.mTextureCoords[0][vertex];
      corner.texture << static_cast<float>(uv.x), 1.F - static_cast<float>(uv.y);
    }
    return corner;
  }

  //! Takes whole turns off texture coordinates of an image that repeats.
  static void moveToFirstRepeat(std::array<vpTrackedModelBuilder::Corner, 3> &corners)
  {
    const Eigen::Vector2f lowest = corners[0].texture.cwiseMin(corners[1].texture).cwiseMin(corners[2].texture);
    for (vpTrackedModelBuilder::Corner &corner : corners) {
      corner.texture -= Eigen::Vector2f(std::floor(lowest.x()), std::floor(lowest.y()));
    }
  }

  Material materialOf(const aiMesh &mesh)
  {
    Material result;
    const aiMaterial &material = *m_scene.mMaterials[mesh.mMaterialIndex];
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    aiColor4D color;
    // What assimp makes up where a file has no materials says nothing about the object.
    if (std::string(name.C_Str()) != AI_DEFAULT_MATERIAL_NAME &&
        material.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS) {
      result.color << color.r, color.g, color.b;
    }
    aiString path;
    if (mesh.HasTextureCoords(0) && material.GetTexture(aiTextureType_DIFFUSE, 0, &path) == AI_SUCCESS) {
      result.image = imageAt(path.C_Str());
    }
    return result;
  }

  int imageAt(const std::string &path)
  {
    const auto known = m_images.find(path);
    if (known != m_images.end()) {
      return known->second;
    }
    const aiTexture *embedded = m_scene.GetEmbeddedTexture(path.c_str());
    const int index =
        m_builder.addImage(embedded != nullptr ? decodeEmbedded(*embedded) : readTextureImage(findImage(path)));
    m_images.emplace(path, index);
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

  //! The path as it is written, relative to the model, or just its file name there: files move between computers.
  std::string findImage(std::string path) const
  {
    for (char &c : path) {
      c = c == '\\' ? '/' : c;
    }
    const std::string beside = m_folder + "/" + path;
    if (vpIoTools::checkFilename(beside)) {
      return beside;
    }
    const std::string name = m_folder + "/" + path.substr(path.find_last_of('/') + 1);
    return vpIoTools::checkFilename(name) ? name : path;
  }

  const aiScene &m_scene;
  std::string m_folder;
  vpTrackedModelBuilder &m_builder;
  std::map<std::string, int> m_images;
  bool m_hasTriangles = false;
};
bool hasSurface(const aiScene &scene)
{
  for (unsigned int m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh &mesh = *scene.mMeshes[m];
    const auto isPolygon = [](const aiFace &face) { return face.mNumIndices >= 3; };
    if (std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces, isPolygon)) {
      return true;
    }
  }
  return false;
}

[[noreturn]] void refuseUnreadable(const std::string &file, const std::string &reason)
{
  throw vpException(vpException::ioError, "%s",
                    ("model '" + file + "' cannot be read, is it broken or of another format? " + reason).c_str());
}

[[noreturn]] void refuseWithoutTriangles(const std::string &file)
{
  throw vpException(vpException::badValue, "%s",
                    ("model '" + file + "' has no triangles: lines and clouds of points cannot be tracked").c_str());
}
} // namespace

void importMesh(const std::string &file, double unit, const vpHomogeneousMatrix &oMm, vpTrackedModelBuilder &builder)
{
  Assimp::Importer importer;
  // The frame of the object is the one that its file was written in, for this format as for the others.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene *scene = importer.ReadFile(file, 0);
  if (scene == nullptr) {
    refuseUnreadable(file, importer.GetErrorString());
  }
  if (!hasSurface(*scene)) {
    refuseWithoutTriangles(file);
  }
  // Validation comes first and finds indices out of range, which not all importers look for.
  scene = importer.ApplyPostProcessing(aiProcess_ValidateDataStructure | aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    refuseUnreadable(file, importer.GetErrorString());
  }
  SceneReader reader(*scene, vpIoTools::getParent(file), builder);
  reader.addNode(*scene->mRootNode, toBuilder(oMm, unit, builder.options().unit));
  if (!reader.hasTriangles()) {
    refuseWithoutTriangles(file);
  }
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
