// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshSink_h
#define meshSink_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpTrackedModelBuilder.h>

#include <Eigen/Geometry>

#include <map>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! Takes polygons of a mesh file, in its coordinates, to a builder.
class MeshSink
{
public:
  using Corner = vpTrackedModelBuilder::Corner;

  //! Of a model: a million take 350 MB while they are loaded, and three million 1 GB.
  static constexpr std::size_t mostTriangles = 3000000;

  /*!
    \param file Path, for messages; texture images are looked for beside it.
    \param unit Metres per unit of the file.
    \param oMm Pose of the mesh's frame in the object frame.
  */
  MeshSink(const std::string &file, double unit, const vpHomogeneousMatrix &oMm, vpTrackedModelBuilder &builder);

  const std::string &file() const { return m_file; }
  //! From the file's coordinates to those of the builder.
  const Eigen::Affine3d &placement() const { return m_placement; }
  std::size_t triangles() const { return m_triangles; }
  vpTrackedModelBuilder &builder() { return m_builder; }

  /*!
    Cuts a polygon into triangles.
    \param corners At least three, in the file's coordinates.
    \param image What imageAt() returned.
    \throw vpException where there are too many corners.
  */
  void addPolygon(std::vector<Corner> corners, int image = -1);
  //! \param corners In the builder's coordinates. \throw vpException where there are too many triangles.
  void addTriangle(std::array<Corner, 3> corners, int image);

  //! An image inside the file. \return Its index, -1 where it is empty; it is then counted as missing.
  int addImage(const std::string &name, const vpImage<vpRGBa> &image);
  //! An image in a file: at its path as it is written, relative to the model, or just by its name beside the model.
  int imageAt(const std::string &path);
  //! \return Path of a file that belongs to the model, found as an image is; empty where there is none.
  std::string findBeside(std::string path) const;
  //! \throw vpException where there were no triangles.
  void requireTriangles() const;

private:
  std::string m_file;
  std::string m_folder;
  Eigen::Affine3d m_placement = Eigen::Affine3d::Identity();
  vpTrackedModelBuilder &m_builder;
  std::map<std::string, int> m_images;
  std::size_t m_triangles = 0;
};

//! Colours of a file whose numbers go to 1 or, as some programs write them, to 255. \return In [0, 1].
Eigen::Vector3f toColor(const Eigen::Vector3d &color, double largest);

//! \return The path with %20 and the like replaced by what they stand for.
std::string percentDecoded(const std::string &path);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
