// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/fileBytes.h"
#include "files/meshFormats.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
constexpr std::size_t headerBytes = 80;
constexpr std::size_t firstFacet = headerBytes + 4;
constexpr std::size_t facetBytes = 50;

std::uint32_t wordAt(const std::string &bytes, std::size_t at)
{
  // Little endian, whatever the processor is.
  std::uint32_t word = 0;
  for (std::size_t i = 4; i > 0; --i) {
    word = (word << 8U) | static_cast<unsigned char>(bytes[at + i - 1]);
  }
  return word;
}

float floatAt(const std::string &bytes, std::size_t at)
{
  const std::uint32_t word = wordAt(bytes, at);
  float value = 0.F;
  std::memcpy(&value, &word, sizeof(value));
  return value;
}

std::size_t expectedSize(const std::string &bytes)
{
  return firstFacet + facetBytes * static_cast<std::size_t>(wordAt(bytes, headerBytes));
}

// Binary files may start with "solid" as well: their size, or a byte that is no text, tells.
bool isBinary(const std::string &bytes)
{
  if (bytes.size() >= firstFacet && bytes.size() == expectedSize(bytes)) {
    return true;
  }
  std::string_view text = std::string_view(bytes).substr(0, 512);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return lowerCase(text.substr(0, 5)) != "solid" || text.find('\0') != std::string_view::npos;
}

// Of the two ways to put colours into the two bytes after a facet, the one of Materialise names itself in the header.
void setColor(const std::string &bytes, std::size_t at, bool isMaterialise, std::vector<MeshSink::Corner> &corners)
{
  const unsigned int low = static_cast<unsigned char>(bytes[at]);
  const unsigned int color = low | (static_cast<unsigned int>(static_cast<unsigned char>(bytes[at + 1])) << 8U);
  if (((color >> 15U) == 1U) == isMaterialise) {
    return;
  }
  const auto part = [&](unsigned int shift) { return static_cast<float>((color >> shift) & 31U) / 31.F; };
  Eigen::Vector3f rgb(part(10), part(5), part(0));
  for (MeshSink::Corner &corner : corners) {
    corner.color = isMaterialise ? Eigen::Vector3f(rgb.reverse()) : rgb;
  }
}

// The size tells the number of facets where the header does not: some programs write it before they know.
std::size_t countFacets(MeshSink &sink, const std::string &bytes)
{
  const std::size_t room = (bytes.size() - firstFacet) / facetBytes;
  const std::uint32_t told = wordAt(bytes, headerBytes);
  const bool isUnknown = told == 0 || told == 0xFFFFFFFFU;
  if (isUnknown && room > 0 && bytes.size() == firstFacet + room * facetBytes) {
    sink.builder().addWarning("'" + sink.file() + "' tells no number of triangles in its header: all " +
                              std::to_string(room) + " that it has room for are read");
    return room;
  }
  if (bytes.size() < expectedSize(bytes)) {
    refuseFile(sink.file(), "is cut off, or of another format: its header says " + std::to_string(told) +
                                " triangles, it has room for " + std::to_string(room));
  }
  if (bytes.size() > expectedSize(bytes)) {
    sink.builder().addWarning("'" + sink.file() + "' goes on after the number of triangles that its header says");
  }
  return told;
}

void readBinary(MeshSink &sink, const std::string &bytes)
{
  if (bytes.size() < firstFacet) {
    refuseFile(sink.file(), "is no STL file, or cut off: it has " + std::to_string(bytes.size()) + " bytes");
  }
  const std::size_t facets = countFacets(sink, bytes);
  const bool isMaterialise = std::string_view(bytes).substr(0, headerBytes).find("COLOR=") != std::string_view::npos;
  std::vector<MeshSink::Corner> corners(3);
  for (std::size_t at = firstFacet; at < firstFacet + facets * facetBytes; at += facetBytes) {
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = MeshSink::Corner();
      for (std::size_t i = 0; i < 3; ++i) {
        corners[k].position[static_cast<Eigen::Index>(i)] =
            static_cast<double>(floatAt(bytes, at + 12 + 12 * k + 4 * i));
      }
    }
    setColor(bytes, at + facetBytes - 2, isMaterialise, corners);
    sink.addPolygon(corners);
  }
}

// The words of a text file, with their lines.
class StlText
{
public:
  StlText(MeshSink &sink, const std::string &text) : m_sink(sink), m_lines(text) {}

  void read()
  {
    bool inSolid = false;
    while (nextLine()) {
      const std::string key = word();
      if (key == "solid" && !inSolid) {
        inSolid = true; // What follows is its name.
      } else if (key == "endsolid" && inSolid) {
        inSolid = false;
      } else if (key == "facet" && inSolid) {
        readFacet();
      } else if (key != "color") {
        refuse("'" + key.substr(0, 20) + "' where a facet or endsolid is to stand");
      }
    }
    if (inSolid) {
      m_sink.builder().addWarning("'" + m_sink.file() + "' does not end with endsolid: is it whole?");
    }
  }

private:
  [[noreturn]] void refuse(const std::string &reason) const { refuseLine(m_sink.file(), m_lines.number(), reason); }
  std::string word() { return lowerCase(takeWord(m_rest)); }

  // The next line with anything in it.
  bool nextLine()
  {
    while (m_lines.next()) {
      m_rest = trimmed(m_lines.line());
      if (!m_rest.empty()) {
        return true;
      }
    }
    return false;
  }

  void expect(const std::string &first, const std::string &second)
  {
    const std::string meant = second.empty() ? first : first + " " + second;
    if (!nextLine()) {
      refuse("the file ends where " + meant + " is to stand: it was cut off");
    }
    if (word() != first || (!second.empty() && word() != second)) {
      refuse("'" + meant + "' is to stand here");
    }
  }

  void readFacet()
  {
    expect("outer", "loop");
    std::vector<MeshSink::Corner> corners(3);
    for (MeshSink::Corner &corner : corners) {
      expect("vertex", "");
      for (Eigen::Index i = 0; i < 3; ++i) {
        const std::string_view number = takeWord(m_rest);
        if (!parseNumber(number, corner.position[i])) {
          refuse(number.empty() ? "a coordinate is missing" : "'" + std::string(number) + "' is no coordinate");
        }
      }
      if (!trimmed(m_rest).empty()) {
        refuse("a vertex has three coordinates, here is more");
      }
    }
    expect("endloop", "");
    expect("endfacet", "");
    m_sink.addPolygon(corners);
  }

  MeshSink &m_sink;
  LineWalk m_lines;
  std::string_view m_rest;
};
} // namespace

void readStl(MeshSink &sink)
{
  std::string bytes = readBytes(sink.file());
  const bool hasBinarySize = bytes.size() >= firstFacet && bytes.size() == expectedSize(bytes);
  if (!hasBinarySize) {
    dropByteOrderMark(sink.file(), bytes);
  }
  if (isBinary(bytes)) {
    readBinary(sink, bytes);
  } else {
    StlText(sink, bytes).read();
  }
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
