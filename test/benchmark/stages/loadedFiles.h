// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchLoadedFiles_h
#define benchLoadedFiles_h

#include <meshFiles.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*!
  \file loadedFiles.h
  The files that loading is timed with: a lump as scanners make them, with shared vertices, in each format.
*/

namespace bench {

//! A ball of 0.2 m with bumps. \param triangles About how many.
struct SharedMesh
{
  explicit SharedMesh(int triangles)
  {
    const int side = static_cast<int>(std::sqrt(triangles / 2.));
    for (int i = 0; i <= side; ++i) {
      for (int j = 0; j < side; ++j) {
        const double polar = M_PI * i / side;
        const double azimuth = 2. * M_PI * j / side;
        const double radius = 0.1 * (1. + 0.1 * std::sin(5. * azimuth) * std::sin(4. * polar));
        vertices.emplace_back(radius * std::sin(polar) * std::cos(azimuth),
                              radius * std::sin(polar) * std::sin(azimuth), radius * std::cos(polar));
        const int right = i * side + (j + 1) % side;
        if (i < side) {
          faces.push_back({{i * side + j, (i + 1) * side + j, right + side}});
          faces.push_back({{i * side + j, right + side, right}});
        }
      }
    }
  }

  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;
};

//! A file of so many triangles.
struct LoadedFile
{
  const char *format; //!< Its extension.
  int triangles;

  std::string name() const { return std::string(format) + "-" + std::to_string(triangles / 1000) + "k"; }

  //! \return Its path.
  std::string write(const meshFiles::TemporaryFolder &folder) const
  {
    const SharedMesh mesh(triangles);
    const std::string kind = format;
    return folder.write("lump." + kind, kind == "ply"   ? ply(mesh)
                                        : kind == "stl" ? stl(mesh)
                                                        : text(mesh, kind == "cao"));
  }

private:
  //! An .obj or .cao file.
  static std::string text(const SharedMesh &mesh, bool isCao)
  {
    std::ostringstream text;
    text.precision(7);
    text << (isCao ? "V1\n" + std::to_string(mesh.vertices.size()) + "\n" : "");
    for (const Eigen::Vector3d &vertex : mesh.vertices) {
      text << (isCao ? "" : "v ") << vertex.x() << " " << vertex.y() << " " << vertex.z() << "\n";
    }
    text << (isCao ? "0\n0\n" + std::to_string(mesh.faces.size()) + "\n" : "");
    for (const std::array<int, 3> &face : mesh.faces) {
      const int first = isCao ? 0 : 1; // Number of the first vertex.
      text << (isCao ? "3 " : "f ") << face[0] + first << " " << face[1] + first << " " << face[2] + first << "\n";
    }
    text << (isCao ? "0\n0\n" : "");
    return text.str();
  }

  static void append(std::string &bytes, const Eigen::Vector3d &vertex)
  {
    for (Eigen::Index i = 0; i < 3; ++i) {
      meshFiles::append(bytes, static_cast<float>(vertex[i]));
    }
  }

  static std::string ply(const SharedMesh &mesh)
  {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                        std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Eigen::Vector3d &vertex : mesh.vertices) {
      append(bytes, vertex);
    }
    for (const std::array<int, 3> &face : mesh.faces) {
      bytes += '\3';
      for (const int vertex : face) {
        meshFiles::append(bytes, static_cast<std::int32_t>(vertex));
      }
    }
    return bytes;
  }

  static std::string stl(const SharedMesh &mesh)
  {
    std::string bytes(80, ' ');
    meshFiles::append(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const std::array<int, 3> &face : mesh.faces) {
      bytes.append(12, '\0');
      for (const int vertex : face) {
        append(bytes, mesh.vertices[static_cast<std::size_t>(vertex)]);
      }
      bytes.append(2, '\0');
    }
    return bytes;
  }
};

//! What a tracker is given, and more than anybody should give it. ViSP's format is read up to 100,000 faces.
inline const std::vector<LoadedFile> &loadedFiles()
{
  static const std::vector<LoadedFile> files = {{"obj", 30000},   {"ply", 30000},   {"stl", 30000}, {"obj", 1000000},
                                                {"ply", 1000000}, {"stl", 1000000}, {"cao", 20000}, {"cao", 100000}};
  return files;
}

} // namespace bench
#endif
