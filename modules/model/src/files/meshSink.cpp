// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/meshSink.h"

#include "files/fileBytes.h"
#include "mesh/polygonTriangulation.h"
#include "mesh/textureImage.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// Cutting a polygon takes time that grows with the square of its corners, or worse.
constexpr std::size_t mostCorners = 1000;

// Takes whole turns off texture coordinates of an image that repeats.
void moveToFirstRepeat(std::array<MeshSink::Corner, 3> &corners)
{
  const Eigen::Vector2f lowest = corners[0].texture.cwiseMin(corners[1].texture).cwiseMin(corners[2].texture);
  for (MeshSink::Corner &corner : corners) {
    corner.texture -= Eigen::Vector2f(std::floor(lowest.x()), std::floor(lowest.y()));
  }
}

std::vector<std::array<int, 3>> cut(const std::vector<MeshSink::Corner> &corners)
{
  std::vector<Eigen::Vector3d> points;
  for (const MeshSink::Corner &corner : corners) {
    points.push_back(corner.position);
  }
  const Eigen::Vector3d normal = newellNormal(points);
  std::vector<std::array<int, 3>> triangles;
  if (points.size() > 3 && normal.allFinite() && normal.norm() > 0.) {
    triangles = triangulatePolygon(points, normal.normalized());
  }
  // What has no area is told by the report, and what is not finite by the builder.
  for (int k = 2; triangles.empty() && k < static_cast<int>(points.size()); ++k) {
    triangles.push_back({{0, k - 1, k}});
  }
  return triangles;
}

bool isFile(const std::string &path)
{
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}
} // namespace

MeshSink::MeshSink(const std::string &file, double unit, const vpHomogeneousMatrix &oMm, vpTrackedModelBuilder &builder)
    : m_file(file), m_folder(std::filesystem::path(file).parent_path().string()), m_builder(builder)
{
  const double builderUnit = builder.options().unit;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      m_placement.matrix()(i, j) = oMm[i][j] * (unit / builderUnit);
    }
    m_placement.matrix()(i, 3) = oMm[i][3] / builderUnit;
  }
}

void MeshSink::addPolygon(std::vector<Corner> corners, int image)
{
  if (corners.size() > mostCorners) {
    refuseFile(m_file, "has a polygon of " + std::to_string(corners.size()) + " corners: cut it into ones of at most " +
                           std::to_string(mostCorners));
  }
  for (Corner &corner : corners) {
    corner.position = m_placement * corner.position;
  }
  if (corners.size() == 3) {
    addTriangle({{corners[0], corners[1], corners[2]}}, image);
    return;
  }
  for (const std::array<int, 3> &triangle : cut(corners)) {
    const auto at = [&](std::size_t k) { return corners[static_cast<std::size_t>(triangle[k])]; };
    addTriangle({{at(0), at(1), at(2)}}, image);
  }
}

void MeshSink::addTriangle(std::array<Corner, 3> corners, int image)
{
  if (image >= 0) {
    moveToFirstRepeat(corners);
  }
  if (++m_triangles > mostTriangles) {
    refuseFile(m_file, "has more than " + std::to_string(mostTriangles) +
                           " triangles: reduce them, a tracker needs thousands of them, not millions");
  }
  m_builder.addTriangle(corners, image);
}

int MeshSink::addImage(const std::string &name, const vpImage<vpRGBa> &image)
{
  const int index = m_builder.addImage(image);
  m_images.emplace(name, index);
  return index;
}

int MeshSink::imageAt(const std::string &path)
{
  const auto known = m_images.find(path);
  if (known != m_images.end()) {
    return known->second;
  }
  const std::string found = findBeside(path);
  return addImage(path, found.empty() ? vpImage<vpRGBa>() : readTextureImage(found));
}

std::string MeshSink::findBeside(std::string path) const
{
  std::replace(path.begin(), path.end(), '\\', '/');
  for (const std::string &name : {path, percentDecoded(path)}) {
    for (const std::string &tail : {name, name.substr(name.find_last_of('/') + 1)}) {
      const std::string beside = (std::filesystem::path(m_folder) / tail).string();
      if (isFile(beside)) {
        return beside;
      }
    }
  }
  return "";
}

void MeshSink::requireTriangles() const
{
  if (m_triangles == 0) {
    throw vpException(vpException::badValue,
                      "model '" + m_file + "' has no triangles: lines and clouds of points cannot be tracked");
  }
}

Eigen::Vector3f toColor(const Eigen::Vector3d &color, double largest)
{
  // A little above 1 is what rounding leaves.
  const double scale = largest > 1.01 ? 255. : 1.;
  return (color / scale).cwiseMax(0.).cwiseMin(1.).cast<float>();
}

std::string percentDecoded(const std::string &path)
{
  std::string decoded;
  for (std::size_t i = 0; i < path.size(); ++i) {
    unsigned char code = 0;
    const char *digits = path.data() + i + 1;
    if (path[i] == '%' && i + 2 < path.size() && std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
      decoded += static_cast<char>(code);
      i += 2;
    } else {
      decoded += path[i];
    }
  }
  return decoded;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
