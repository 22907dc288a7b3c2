// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/plyHeader.h"

#include "files/fileBytes.h"

#include <algorithm>
#include <array>
#include <utility>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
constexpr std::size_t longestHeader = 1U << 20U;
constexpr long long mostRows = 100000000;

struct TypeName
{
  const char *name;
  PlyType type;
};
constexpr std::array<TypeName, 16> typeNames = {{{"char", PlyType::CHAR},
                                                 {"int8", PlyType::CHAR},
                                                 {"uchar", PlyType::UCHAR},
                                                 {"uint8", PlyType::UCHAR},
                                                 {"short", PlyType::SHORT},
                                                 {"int16", PlyType::SHORT},
                                                 {"ushort", PlyType::USHORT},
                                                 {"uint16", PlyType::USHORT},
                                                 {"int", PlyType::INT},
                                                 {"int32", PlyType::INT},
                                                 {"uint", PlyType::UINT},
                                                 {"uint32", PlyType::UINT},
                                                 {"float", PlyType::FLOAT},
                                                 {"float32", PlyType::FLOAT},
                                                 {"double", PlyType::DOUBLE},
                                                 {"float64", PlyType::DOUBLE}}};

// The header's lines, which all end as the first one does: the data may start with a byte that looks like an end.
class HeaderReader
{
public:
  HeaderReader(const std::string &file, std::string_view bytes) : m_file(file), m_bytes(bytes)
  {
    m_next = bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0; // A byte order mark.
    const std::string_view start = bytes.substr(0, longestHeader);
    const std::size_t end = start.find_first_of("\r\n");
    m_end = start.substr(std::min(end, start.size()), start.substr(std::min(end, start.size()), 2) == "\r\n" ? 2 : 1);
  }

  PlyHeader read()
  {
    if (nextLine() != "ply") {
      refuseFile(m_file, "is no PLY file: it does not start with ply");
    }
    bool hasFormat = false;
    for (std::string_view line = nextLine(); line != "end_header"; line = nextLine()) {
      const std::string key(takeWord(line));
      if (key == "format") {
        m_header.format = formatOf(trimmed(line));
        hasFormat = true;
      } else if (key == "comment") {
        readComment(line);
      } else if (key == "element") {
        readElement(line);
      } else if (key == "property") {
        readProperty(line);
      } else if (!key.empty() && key != "obj_info") {
        refuse("'" + key.substr(0, 20) + "' is no keyword of a PLY header");
      }
    }
    if (!hasFormat) {
      refuse("the header does not tell the format");
    }
    m_header.dataStart = m_next;
    return m_header;
  }

private:
  [[noreturn]] void refuse(const std::string &reason) const { refuseLine(m_file, m_header.lines, reason); }

  std::string_view nextLine()
  {
    const std::size_t end = m_end.empty() ? std::string_view::npos : m_bytes.find(m_end, m_next);
    if (end == std::string_view::npos || end > longestHeader) {
      refuseFile(m_file, "has no complete header, is it broken or of another format?");
    }
    const std::string_view line = m_bytes.substr(m_next, end - m_next);
    m_next = end + m_end.size();
    ++m_header.lines;
    return trimmed(line);
  }

  PlyHeader::Format formatOf(std::string_view text) const
  {
    const std::string_view format = takeWord(text);
    if (trimmed(text) != "1.0" ||
        (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")) {
      refuse("the format is to be ascii, binary_little_endian or binary_big_endian, and 1.0");
    }
    return format == "ascii" ? PlyHeader::ASCII : format == "binary_big_endian" ? PlyHeader::BIG : PlyHeader::LITTLE;
  }

  void readComment(std::string_view text)
  {
    if (lowerCase(takeWord(text)) == "texturefile") {
      m_header.images.emplace_back(trimmed(text));
    }
  }

  void readElement(std::string_view text)
  {
    PlyElement element;
    element.name = takeWord(text);
    long long count = 0;
    const std::string word(takeWord(text));
    if (!parseNumber(word, count) || count < 0 || count > mostRows) {
      refuse("element " + element.name + " has the count '" + word + "': it must be a whole number in [0, " +
             std::to_string(mostRows) + "]");
    }
    element.count = static_cast<std::size_t>(count);
    for (const PlyElement &other : m_header.elements) {
      if (other.name == element.name) {
        refuse("element " + element.name + " is there twice");
      }
    }
    m_header.elements.push_back(std::move(element));
  }

  PlyType takeType(std::string_view &text) const
  {
    const std::string_view word = takeWord(text);
    const auto *found =
        std::find_if(typeNames.begin(), typeNames.end(), [&](const TypeName &type) { return word == type.name; });
    if (found == typeNames.end()) {
      refuse("'" + std::string(word) + "' is no type of a property");
    }
    return found->type;
  }

  void readProperty(std::string_view text)
  {
    if (m_header.elements.empty()) {
      refuse("a property stands before the first element");
    }
    PlyProperty property;
    std::string_view rest = text;
    if (takeWord(rest) == "list") {
      text = rest;
      property.isList = true;
      property.countType = takeType(text);
    }
    property.type = takeType(text);
    property.name = takeWord(text);
    if (property.name.empty() || !trimmed(text).empty() || property.countType >= PlyType::FLOAT) {
      refuse("a property is to be 'property float x' or 'property list uchar int vertex_indices'");
    }
    m_header.elements.back().properties.push_back(std::move(property));
  }

  std::string m_file;
  std::string_view m_bytes;
  std::string_view m_end; // Of a line.
  std::size_t m_next = 0;
  PlyHeader m_header;
};
} // namespace

std::size_t sizeOf(PlyType type)
{
  switch (type) {
  case PlyType::CHAR:
  case PlyType::UCHAR:
    return 1;
  case PlyType::SHORT:
  case PlyType::USHORT:
    return 2;
  case PlyType::DOUBLE:
    return 8;
  default:
    return 4;
  }
}

double colorScale(PlyType type)
{
  switch (type) {
  case PlyType::UCHAR:
    return 255.;
  case PlyType::USHORT:
    return 65535.;
  default:
    return 1.;
  }
}

int PlyElement::find(const std::vector<const char *> &names) const
{
  for (std::size_t i = 0; i < properties.size(); ++i) {
    for (const char *one : names) {
      if (properties[i].name == one) {
        return static_cast<int>(i);
      }
    }
  }
  return -1;
}

PlyHeader PlyHeader::read(const std::string &file, std::string_view bytes)
{
  return HeaderReader(file, bytes).read();
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
