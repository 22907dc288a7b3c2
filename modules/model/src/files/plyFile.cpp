// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/meshFormats.h"
#include "files/plyRows.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <array>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
class PlyReader
{
public:
  explicit PlyReader(MeshSink &sink)
      : m_sink(sink), m_bytes(readBytes(sink.file())), m_header(PlyHeader::read(sink.file(), m_bytes)),
        m_rows(sink.file(), m_bytes, m_header)
  {
  }

  void read()
  {
    for (const PlyElement &element : m_header.elements) {
      m_rows.requireRoom(element);
      if (element.name == "vertex") {
        readVertices(element);
      } else if (element.name == "face") {
        readFaces(element);
      } else if (element.name == "tristrips") {
        readStrips(element);
      } else {
        for (std::size_t i = 0; i < element.count; ++i) {
          m_rows.next(element, m_values);
        }
      }
    }
    if (!m_rows.atEnd()) {
      const std::string text = "goes on after what its header tells: is a count too small?";
      if (m_header.format == PlyHeader::ASCII) {
        refuseFile(m_sink.file(), text);
      }
      m_sink.builder().addWarning("'" + m_sink.file() + "' " + text);
    }
    addFaces();
  }

private:
  struct Face
  {
    std::size_t first; // Of m_corners.
    std::size_t count;
    int image;
    bool hasTexture; // Of its own, in m_cornerTextures.
  };

  // Where the three properties of a colour are, if there are any.
  struct ColorPlace
  {
    explicit ColorPlace(const PlyElement &element)
        : at({{element.find({"red", "diffuse_red", "r"}), element.find({"green", "diffuse_green", "g"}),
               element.find({"blue", "diffuse_blue", "b"})}}),
          isThere(at[0] >= 0 && at[1] >= 0 && at[2] >= 0),
          scale(isThere ? colorScale(element.properties[static_cast<std::size_t>(at[0])].type) : 1.)
    {
    }
    Eigen::Vector3f of(const std::vector<std::vector<double>> &values) const
    {
      Eigen::Vector3d color = Eigen::Vector3d::Zero();
      for (Eigen::Index i = 0; i < 3; ++i) {
        const std::vector<double> &value = values[static_cast<std::size_t>(at[static_cast<std::size_t>(i)])];
        color[i] = value.empty() ? 0. : value[0] / scale;
      }
      return toColor(color, color.maxCoeff());
    }

    std::array<int, 3> at;
    bool isThere;
    double scale;
  };

  [[noreturn]] void refuse(const std::string &reason) const
  {
    throw vpException(vpException::ioError, "model '" + m_sink.file() + "', " + m_rows.place() + ": " + reason);
  }

  // A property that is one number.
  int scalar(const PlyElement &element, const std::vector<const char *> &names) const
  {
    const int at = element.find(names);
    return at >= 0 && !element.properties[static_cast<std::size_t>(at)].isList ? at : -1;
  }

  double value(int property) const { return m_values[static_cast<std::size_t>(property)][0]; }

  void readVertices(const PlyElement &element)
  {
    const std::array<int, 3> position = {{scalar(element, {"x"}), scalar(element, {"y"}), scalar(element, {"z"})}};
    const int u = scalar(element, {"s", "u", "texture_u", "texture_s"});
    const int v = scalar(element, {"t", "v", "texture_v", "texture_t"});
    if (element.count > 0 && std::find(position.begin(), position.end(), -1) != position.end()) {
      refuseFile(m_sink.file(), "has vertices without the properties x, y and z");
    }
    const ColorPlace color(element);
    for (std::size_t i = 0; i < element.count; ++i) {
      m_rows.next(element, m_values);
      m_positions.emplace_back(value(position[0]), value(position[1]), value(position[2]));
      if (color.isThere) {
        m_colors.push_back(color.of(m_values));
      }
      if (u >= 0 && v >= 0) {
        m_textures.emplace_back(static_cast<float>(value(u)), static_cast<float>(value(v)));
      }
    }
  }

  int listOf(const PlyElement &element) const
  {
    const int list = element.find({"vertex_indices", "vertex_index"});
    if (element.count > 0 && (list < 0 || !element.properties[static_cast<std::size_t>(list)].isList)) {
      refuseFile(m_sink.file(), "has an element " + element.name + " without a list vertex_indices");
    }
    return list;
  }

  void readFaces(const PlyElement &element)
  {
    const int list = listOf(element);
    const int textures = element.find({"texcoord"});
    const int image = scalar(element, {"texnumber"});
    const ColorPlace color(element);
    for (std::size_t i = 0; i < element.count; ++i) {
      m_rows.next(element, m_values);
      const std::vector<double> &corners = m_values[static_cast<std::size_t>(list)];
      if (corners.size() < 3) {
        refuse("a face of " + std::to_string(corners.size()) + " corners is none");
      }
      Face face = {m_corners.size(), corners.size(), imageNumber(image), false};
      addCorners(corners);
      m_cornerTextures.resize(m_corners.size(), Eigen::Vector2f::Zero());
      if (textures >= 0 && m_values[static_cast<std::size_t>(textures)].size() == 2 * corners.size()) {
        face.hasTexture = true;
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const double *pair = m_values[static_cast<std::size_t>(textures)].data() + 2 * k;
          m_cornerTextures[face.first + k] << static_cast<float>(pair[0]), static_cast<float>(pair[1]);
        }
      }
      m_faces.push_back(face);
      if (color.isThere) {
        m_faceColors.push_back(color.of(m_values));
      }
    }
  }

  // Which of the header's texture files; -1 for what is none.
  int imageNumber(int property) const
  {
    const double number = property >= 0 ? value(property) : 0.;
    return number >= 0. && number < static_cast<double>(m_header.images.size()) ? static_cast<int>(number) : -1;
  }

  // Each index makes a triangle with the two before it, every other one turned over; -1 starts anew.
  void readStrips(const PlyElement &element)
  {
    const int list = listOf(element);
    for (std::size_t i = 0; i < element.count; ++i) {
      m_rows.next(element, m_values);
      std::vector<double> strip;
      std::vector<double> indices = m_values[static_cast<std::size_t>(list)];
      indices.push_back(-1.);
      for (const double index : indices) {
        if (vpIsOther(index, -1.)) {
          strip.push_back(index);
          continue;
        }
        for (std::size_t k = 2; k < strip.size(); ++k) {
          addStripTriangle(strip, k);
        }
        strip.clear();
      }
    }
  }

  void addStripTriangle(const std::vector<double> &strip, std::size_t k)
  {
    const std::size_t odd = k % 2;
    const std::vector<double> corners = {strip[k - 2 + odd], strip[k - 1 - odd], strip[k]};
    // Strips are sewn together with triangles that have a corner twice.
    if (vpIsOther(corners[0], corners[1]) && vpIsOther(corners[1], corners[2]) && vpIsOther(corners[2], corners[0])) {
      m_faces.push_back({m_corners.size(), 3, 0, false});
      addCorners(corners);
      m_cornerTextures.resize(m_corners.size(), Eigen::Vector2f::Zero());
    }
  }

  void addCorners(const std::vector<double> &corners)
  {
    // Vertices may come later in the file: addFaces() looks whether they are there.
    for (const double corner : corners) {
      if (!(corner >= 0.) || corner > 4294967295.) {
        refuse("the index " + std::to_string(corner) + " is none of a vertex");
      }
      m_corners.push_back(static_cast<std::size_t>(corner));
    }
  }

  int imageOf(const Face &face) const
  {
    const bool textured = face.hasTexture || !m_textures.empty();
    if (!textured || face.image < 0 || static_cast<std::size_t>(face.image) >= m_header.images.size()) {
      return -1;
    }
    return m_sink.imageAt(m_header.images[static_cast<std::size_t>(face.image)]);
  }

  void addFaces()
  {
    std::vector<MeshSink::Corner> corners;
    for (std::size_t f = 0; f < m_faces.size(); ++f) {
      const Face &face = m_faces[f];
      const int image = imageOf(face);
      corners.assign(face.count, MeshSink::Corner());
      for (std::size_t k = 0; k < face.count; ++k) {
        const std::size_t vertex = m_corners[face.first + k];
        if (vertex >= m_positions.size()) {
          refuseFile(m_sink.file(), "has a face with the index " + std::to_string(vertex) + ", but there are " +
                                        std::to_string(m_positions.size()) + " vertices, the first is 0");
        }
        MeshSink::Corner &corner = corners[k];
        corner.position = m_positions[vertex];
        corner.color = f < m_faceColors.size() ? m_faceColors[f] : corner.color;
        corner.color = m_colors.empty() ? corner.color : m_colors[vertex];
        if (image >= 0) {
          const Eigen::Vector2f &uv = face.hasTexture ? m_cornerTextures[face.first + k] : m_textures[vertex];
          corner.texture << uv.x(), 1.F - uv.y();
        }
      }
      m_sink.addPolygon(corners, image);
    }
  }

  MeshSink &m_sink;
  std::string m_bytes;
  PlyHeader m_header;
  PlyRows m_rows;
  std::vector<std::vector<double>> m_values; // Of the current row.
  std::vector<Eigen::Vector3d> m_positions;
  std::vector<Eigen::Vector3f> m_colors;
  std::vector<Eigen::Vector2f> m_textures;
  std::vector<std::size_t> m_corners;
  std::vector<Eigen::Vector2f> m_cornerTextures;
  std::vector<Face> m_faces;
  std::vector<Eigen::Vector3f> m_faceColors;
};
} // namespace

void readPly(MeshSink &sink)
{
  PlyReader(sink).read();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
