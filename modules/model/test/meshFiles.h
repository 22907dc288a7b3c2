// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshFiles_h
#define meshFiles_h

#include "modelShapes.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

/*!
  \file meshFiles.h
  Writes triangles in the formats that vpModelReader reads. Nothing is shared: every triangle has corners of its own.
*/

BEGIN_VISP_NAMESPACE
namespace meshFiles {
using Triangles = std::vector<modelShapes::Triangle>;

//! A folder that is removed with everything in it.
class TemporaryFolder
{
public:
  TemporaryFolder()
      : m_path(std::filesystem::temp_directory_path() / ("model-reader-" + std::to_string(std::random_device{}())))
  {
    std::filesystem::create_directories(m_path);
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  std::string path(const std::string &name) const { return (m_path / name).string(); }

  //! Writes a file. \return Its path.
  std::string write(const std::string &name, const std::string &content) const
  {
    // A file that is made anew is kept in memory; one that is overwritten is written to the disk at once by ext4.
    std::error_code ignored;
    std::filesystem::remove(m_path / name, ignored);
    std::ofstream(m_path / name, std::ios::binary) << content;
    return path(name);
  }

private:
  std::filesystem::path m_path;
};

//! Path of a file in a folder that lives as long as the test program.
inline std::string temporaryFile(const std::string &name)
{
  static const TemporaryFolder folder;
  return folder.path(name);
}

template <class Number> void append(std::string &bytes, Number number)
{
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

//! Corner positions as 32-bit floats, x y z.
inline std::string floats(const Triangles &triangles)
{
  std::string bytes;
  for (const modelShapes::Triangle &triangle : triangles) {
    for (const modelShapes::Point &corner : triangle) {
      for (int i = 0; i < 3; ++i) {
        append(bytes, static_cast<float>(corner[i]));
      }
    }
  }
  return bytes;
}

//! Corner positions as text, one corner a line, after \e prefix.
inline std::string lines(const Triangles &triangles, const std::string &prefix)
{
  std::ostringstream text;
  for (const modelShapes::Triangle &triangle : triangles) {
    for (const modelShapes::Point &corner : triangle) {
      text << prefix << corner.x() << " " << corner.y() << " " << corner.z() << "\n";
    }
  }
  return text.str();
}

inline std::string obj(const Triangles &triangles)
{
  std::ostringstream text;
  text << lines(triangles, "v ");
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    text << "f " << 3 * t + 1 << " " << 3 * t + 2 << " " << 3 * t + 3 << "\n";
  }
  return text.str();
}

inline std::string ply(const Triangles &triangles)
{
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nelement vertex " << 3 * triangles.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << triangles.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n"
       << lines(triangles, "");
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    text << "3 " << 3 * t << " " << 3 * t + 1 << " " << 3 * t + 2 << "\n";
  }
  return text.str();
}

//! Of vertices with colours after their positions; faces of any number of corners.
inline std::string coloredPlyHeader(std::size_t vertices, std::size_t faces)
{
  std::ostringstream text;
  text << "ply\nformat ascii 1.0\nelement vertex " << vertices
       << "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
       << "property uchar blue\nelement face " << faces << "\nproperty list uchar int vertex_indices\nend_header\n";
  return text.str();
}

inline std::string asciiStl(const Triangles &triangles)
{
  std::ostringstream text;
  text << "solid shape\n";
  for (const modelShapes::Triangle &triangle : triangles) {
    text << "facet normal 0 0 0\nouter loop\n" << lines({triangle}, "vertex ") << "endloop\nendfacet\n";
  }
  text << "endsolid shape\n";
  return text.str();
}

inline std::string binaryStl(const Triangles &triangles)
{
  std::string bytes(80, ' ');
  append(bytes, static_cast<std::uint32_t>(triangles.size()));
  for (const modelShapes::Triangle &triangle : triangles) {
    bytes.append(12, '\0');
    bytes += floats({triangle});
    bytes.append(2, '\0');
  }
  return bytes;
}

//! \param asset What stands in the asset element: unit and up axis. \param node Transformation of the node.
inline std::string dae(const Triangles &triangles, const std::string &asset, const std::string &node = "")
{
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
       << "<asset>" << asset << "</asset><library_geometries><geometry id=\"g\"><mesh><source id=\"p\">"
       << "<float_array id=\"a\" count=\"" << 9 * triangles.size() << "\">" << lines(triangles, "")
       << "</float_array><technique_common><accessor source=\"#a\" count=\"" << 3 * triangles.size()
       << "\" stride=\"3\"><param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/><param name=\"Z\" "
          "type=\"float\"/></accessor></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" "
          "source=\"#p\"/></vertices><triangles count=\""
       << triangles.size() << "\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>";
  for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
    text << i << " ";
  }
  text << "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\"><node "
          "id=\"n\">"
       << node << "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes><scene>"
       << "<instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
  return text.str();
}

//! \param buffer The member that says where the bytes of floats() are, or nothing in a .glb file.
inline std::string gltfJson(const Triangles &triangles, const std::string &buffer, const std::string &node = "")
{
  const std::string count = std::to_string(3 * triangles.size());
  const std::string bytes = std::to_string(36 * triangles.size());
  return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0" + node +
         "}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"buffers\":[{" + buffer +
         "\"byteLength\":" + bytes + "}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + bytes +
         "}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":" + count +
         ",\"type\":\"VEC3\",\"min\":[-100,-100,-100],\"max\":[100,100,100]}]}";
}

inline std::string glb(const Triangles &triangles)
{
  std::string json = gltfJson(triangles, "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string data = floats(triangles);
  std::string bytes = "glTF";
  append(bytes, std::uint32_t{2});
  append(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + data.size()));
  append(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append(bytes, static_cast<std::uint32_t>(data.size()));
  bytes.append("BIN\0", 4);
  return bytes + data;
}
} // namespace meshFiles
END_VISP_NAMESPACE
#endif
