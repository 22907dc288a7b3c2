// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/fileBytes.h"
#include "files/meshFormats.h"
#include "files/mtlFile.h"

#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <array>
#include <set>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// What the format knows and a surface of triangles does not need.
const std::set<std::string> &passedOver()
{
  static const std::set<std::string> words = {
      "vn",    "vp",    "l",     "p",    "g",      "o",        "s",        "usemap",     "maplib",   "mg", "lod",
      "bevel", "deg",   "bmat",  "step", "cstype", "parm",     "trim",     "hole",       "scrv",     "sp", "end",
      "con",   "ctech", "stech", "call", "csh",    "c_interp", "d_interp", "shadow_obj", "trace_obj"};
  return words;
}

// What the format knows and is part of a surface, but not of triangles.
const std::array<const char *, 8> freeForm = {{"curv", "curv2", "surf", "bzp", "bsp", "cdc", "cdp", "res"}};

// Lines without a keyword; a file with more is none.
constexpr std::size_t mostUnknown = 100000;

class ObjReader
{
public:
  explicit ObjReader(MeshSink &sink) : m_sink(sink), m_text(readBytes(sink.file())), m_materials(sink)
  {
    dropByteOrderMark(sink.file(), m_text);
  }

  void read()
  {
    std::string joined;
    LineWalk lines(m_text);
    while (lines.next()) {
      m_line = lines.number();
      std::string_view line = withoutComment(lines.line());
      // A comment does not go on in the next line, whatever it ends with.
      joined = line;
      while (!joined.empty() && joined.back() == '\\' && lines.next()) {
        joined.pop_back();
        joined += ' ';
        joined += withoutComment(lines.line());
      }
      readLine(joined);
    }
    if (lines.endsInLine() && !joined.empty()) {
      m_sink.builder().addWarning("'" + m_sink.file() + "' has no line end after its last line: is it whole?");
    }
    if (m_unknown > 0) {
      m_sink.builder().addWarning("'" + m_sink.file() + "' has " + std::to_string(m_unknown) +
                                  " lines without a keyword of .obj files, the first one is " + m_firstUnknown);
    }
    addFaces();
  }

private:
  struct Face
  {
    std::size_t first;
    std::size_t count;
    int material;
    std::size_t line;
  };
  struct Corner
  {
    std::size_t position;
    long long texture; // -1 for none.
  };

  [[noreturn]] void refuse(const std::string &reason) const { refuseLine(m_sink.file(), m_line, reason); }

  // Names may have a # in them.
  static std::string_view withoutComment(std::string_view line)
  {
    std::size_t end = line.find('#');
    while (end != std::string_view::npos && end > 0 && line[end - 1] != ' ' && line[end - 1] != '\t' &&
           !isNumeric(line)) {
      end = line.find('#', end + 1);
    }
    return trimmed(line.substr(0, end));
  }

  static bool isNumeric(std::string_view line)
  {
    const std::string_view key = takeWord(line);
    return key == "v" || key == "vt" || key == "vn" || key == "f";
  }

  void readLine(std::string_view line)
  {
    const std::string key(takeWord(line));
    if (key.empty() || passedOver().count(key) != 0) {
      return;
    }
    if (key == "v") {
      addVertex(line);
    } else if (key == "vt") {
      addTexture(line);
    } else if (key == "f" || key == "fo") {
      addFace(line);
    } else if (key == "usemtl") {
      m_material = m_materials.index(std::string(trimmed(line)));
    } else if (key == "mtllib") {
      m_materials.addFiles(std::string(trimmed(line)));
    } else if (std::find(freeForm.begin(), freeForm.end(), key) != freeForm.end()) {
      m_sink.builder().addWarning("free-form curves and surfaces of '" + m_sink.file() +
                                  "' are left out: export the model as triangles");
    } else {
      addUnknown(key);
    }
  }

  // Other readers pass over what they do not know, so that files have it: colours of vertices for instance.
  void addUnknown(const std::string &key)
  {
    if (++m_unknown == 1) {
      m_firstUnknown = "line " + std::to_string(m_line) + ", '" + key.substr(0, 20) + "'";
    } else if (m_unknown > mostUnknown) {
      refuse("'" + key.substr(0, 20) + "' is no keyword of an .obj file, like that of " + m_firstUnknown +
             ", and too many others");
    }
  }

  std::vector<double> numbersOf(std::string_view line, const std::string &what) const
  {
    std::vector<double> numbers;
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      double number = 0.;
      if (!parseNumber(word, number)) {
        refuse("'" + std::string(word) + "' is no number of a " + what +
               (word.find(',') != std::string_view::npos ? ": a decimal comma? Write numbers with a point" : ""));
      }
      numbers.push_back(number);
    }
    return numbers;
  }

  void addVertex(std::string_view line)
  {
    const std::vector<double> numbers = numbersOf(line, "vertex");
    if (numbers.size() != 3 && numbers.size() != 4 && numbers.size() != 6 && numbers.size() != 7) {
      refuse("a vertex has three coordinates, and may have a weight and three colours, but here are " +
             std::to_string(numbers.size()) + " numbers");
    }
    m_positions.emplace_back(numbers[0], numbers[1], numbers[2]);
    if ((numbers.size() == 4 || numbers.size() == 7) && vpIsOther(numbers[3], 1.)) {
      m_sink.builder().addWarning("'" + m_sink.file() +
                                  "' has vertices with a weight other than 1, which only curves " +
                                  "have: are there too many numbers?");
    }
    if (!m_positions.back().allFinite()) {
      refuse("a coordinate is not finite");
    }
    if (numbers.size() >= 6) {
      m_colors.resize(m_positions.size(), Eigen::Vector3d::Constant(-1.));
      const Eigen::Vector3d color(numbers[numbers.size() - 3], numbers[numbers.size() - 2], numbers.back());
      if (!(color.minCoeff() >= 0.) || !(color.maxCoeff() <= 255.)) {
        refuse("a colour is neither in [0, 1] nor in [0, 255]");
      }
      m_largestColor = std::max(m_largestColor, color.maxCoeff());
      m_colors.back() = color;
    }
  }

  void addTexture(std::string_view line)
  {
    const std::vector<double> numbers = numbersOf(line, "texture coordinate");
    if (numbers.empty() || numbers.size() > 3) {
      refuse("a texture coordinate has one to three numbers");
    }
    m_textures.emplace_back(static_cast<float>(numbers[0]), numbers.size() > 1 ? static_cast<float>(numbers[1]) : 0.F);
  }

  // Counted from 1 or, with a minus sign, backwards from the last one that there is. What comes later in the file may
  // be meant: requireInRange() looks whether it came.
  std::size_t indexOf(std::string_view word, std::size_t count, const std::string &what) const
  {
    long long index = 0;
    if (!parseNumber(word, index)) {
      refuse("'" + std::string(word) + "' is no index of a " + what);
    }
    const long long fromZero = index < 0 ? static_cast<long long>(count) + index : index - 1;
    if (fromZero < 0) {
      refuse("index " + std::to_string(index) + " of a face is out of range: there are " + std::to_string(count) +
             " of a " + what + " before it, the first is 1");
    }
    return static_cast<std::size_t>(fromZero);
  }

  void requireInRange(const Face &face)
  {
    m_line = face.line;
    const auto require = [this](std::size_t index, std::size_t count, const std::string &what) {
      if (index >= count) {
        refuse("index " + std::to_string(index + 1) + " of a face is out of range: there are " + std::to_string(count) +
               " of a " + what + ", the first is 1");
      }
    };
    for (std::size_t k = face.first; k < face.first + face.count; ++k) {
      require(m_corners[k].position, m_positions.size(), "vertex");
      if (m_corners[k].texture >= 0) {
        require(static_cast<std::size_t>(m_corners[k].texture), m_textures.size(), "texture coordinate");
      }
    }
  }

  void addFace(std::string_view line)
  {
    const std::size_t first = m_corners.size();
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      Corner corner = {indexOf(word.substr(0, slash), m_positions.size(), "vertex"), -1};
      const std::string_view rest = word.substr(std::min(slash + 1, word.size()));
      const std::string_view texture = rest.substr(0, rest.find('/'));
      if (!texture.empty()) {
        corner.texture = static_cast<long long>(indexOf(texture, m_textures.size(), "texture coordinate"));
      }
      m_corners.push_back(corner);
    }
    if (m_corners.size() - first < 3) {
      refuse("a face needs three corners or more, here are " + std::to_string(m_corners.size() - first));
    }
    m_faces.push_back({first, m_corners.size() - first, m_material, m_line});
  }

  void addFaces()
  {
    m_colors.resize(m_colors.empty() ? 0 : m_positions.size(), Eigen::Vector3d::Constant(-1.));
    std::vector<MeshSink::Corner> corners;
    for (const Face &face : m_faces) {
      requireInRange(face);
      const MtlMaterial &material = m_materials.at(face.material);
      const bool textured = std::all_of(m_corners.begin() + static_cast<std::ptrdiff_t>(face.first),
                                        m_corners.begin() + static_cast<std::ptrdiff_t>(face.first + face.count),
                                        [](const Corner &corner) { return corner.texture >= 0; });
      corners.clear();
      for (std::size_t k = 0; k < face.count; ++k) {
        corners.push_back(cornerOf(m_corners[face.first + k], material, textured));
      }
      const bool hasImage = textured && !material.image.empty();
      m_sink.addPolygon(corners, hasImage ? m_sink.imageAt(material.image) : -1);
    }
  }

  MeshSink::Corner cornerOf(const Corner &corner, const MtlMaterial &material, bool textured) const
  {
    MeshSink::Corner result;
    result.position = m_positions[corner.position];
    result.color = material.color.value_or(result.color);
    if (!m_colors.empty() && m_colors[corner.position].x() >= 0.) {
      result.color = toColor(m_colors[corner.position], m_largestColor);
    }
    if (textured) {
      const Eigen::Vector2f &texture = m_textures[static_cast<std::size_t>(corner.texture)];
      result.texture << texture.x(), 1.F - texture.y();
    }
    return result;
  }

  MeshSink &m_sink;
  std::string m_text;
  std::size_t m_line = 0;
  std::vector<Eigen::Vector3d> m_positions;
  std::vector<Eigen::Vector3d> m_colors; // Of positions; negative for none.
  double m_largestColor = 0.;
  std::vector<Eigen::Vector2f> m_textures;
  std::vector<Corner> m_corners;
  std::vector<Face> m_faces;
  std::size_t m_unknown = 0; // Lines.
  std::string m_firstUnknown;
  ObjMaterials m_materials;
  int m_material = -1;
};
} // namespace

void readObj(MeshSink &sink)
{
  ObjReader(sink).read();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
