// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/plyRows.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpExactNumber.h>

#include <cmath>
#include <cstring>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
PlyRows::PlyRows(const std::string &file, std::string_view bytes, const PlyHeader &header)
    : m_file(file), m_bytes(bytes.substr(header.dataStart)), m_format(header.format), m_headerLines(header.lines),
      m_lines(m_bytes)
{
}

std::string PlyRows::place() const
{
  return m_format == PlyHeader::ASCII ? "line " + std::to_string(m_headerLines + m_lines.number())
                                      : m_element + " " + std::to_string(m_row - 1);
}

void PlyRows::refuse(const std::string &reason) const
{
  throw vpException(vpException::ioError, "model '" + m_file + "', " + place() + ": " + reason);
}

void PlyRows::requireRoom(const PlyElement &element) const
{
  std::size_t least = 0; // Bytes of a row; in a text file a digit and a blank for every number.
  for (const PlyProperty &property : element.properties) {
    least += m_format == PlyHeader::ASCII ? 2 : sizeOf(property.isList ? property.countType : property.type);
  }
  if (element.count > 0 && least == 0) {
    refuseFile(m_file, "has an element " + element.name + " without properties");
  }
  // The last number of a file may lack its blank.
  if (element.count > 0 && element.count > (m_bytes.size() + 1) / least) {
    refuseFile(m_file, "is cut off: its header says " + std::to_string(element.count) + " of element " + element.name +
                           ", what follows has no room for them");
  }
}

void PlyRows::next(const PlyElement &element, std::vector<std::vector<double>> &values)
{
  m_row = m_element == element.name ? m_row + 1 : 1;
  m_element = element.name;
  if (m_format == PlyHeader::ASCII) {
    readLine(element);
  }
  values.resize(element.properties.size());
  for (std::size_t p = 0; p < values.size(); ++p) {
    const PlyProperty &property = element.properties[p];
    values[p].clear();
    for (std::size_t left = property.isList ? listSize(property) : 1; left > 0; --left) {
      values[p].push_back(number(property.type));
    }
  }
  if (m_format == PlyHeader::ASCII && !trimmed(m_line).empty()) {
    refuse("there are more numbers than an element " + element.name + " has");
  }
}

void PlyRows::readLine(const PlyElement &element)
{
  do {
    if (!m_lines.next()) {
      refuse("the file ends where " + element.name + " " + std::to_string(m_row - 1) + " of " +
             std::to_string(element.count) + " is to stand: it is cut off, or the header's count is too large");
    }
    m_line = trimmed(m_lines.line());
  } while (m_line.empty());
}

bool PlyRows::atEnd()
{
  if (m_format != PlyHeader::ASCII) {
    return m_bytes.empty();
  }
  while (m_lines.next()) {
    if (!trimmed(m_lines.line()).empty()) {
      return false;
    }
  }
  return true;
}

std::size_t PlyRows::listSize(const PlyProperty &property)
{
  const double size = number(property.countType);
  // A list of more numbers than bytes ends in an error anyway, before memory is taken for it.
  if (size < 0. || size > static_cast<double>(m_format == PlyHeader::ASCII ? m_line.size() : m_bytes.size())) {
    refuse("the list " + property.name + " is said to have " + std::to_string(size) +
           " numbers, which the file has not");
  }
  return static_cast<std::size_t>(size);
}

double PlyRows::number(PlyType type)
{
  if (m_format != PlyHeader::ASCII) {
    return binaryNumber(type);
  }
  const std::string_view text = takeWord(m_line);
  double value = 0.;
  if (text.empty()) {
    refuse("the line has too few numbers");
  }
  if (!parseNumber(text, value)) {
    refuse("'" + std::string(text.substr(0, 20)) + "' is no number");
  }
  if (type < PlyType::FLOAT && vpIsOther(value, std::floor(value))) {
    refuse("'" + std::string(text.substr(0, 20)) + "' is no whole number");
  }
  return value;
}

std::uint64_t PlyRows::word(std::size_t bytes)
{
  if (m_bytes.size() < bytes) {
    refuse("the file ends here: it is cut off, or a count is too large");
  }
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t at = m_format == PlyHeader::BIG ? i : bytes - 1 - i;
    result = (result << 8U) | static_cast<unsigned char>(m_bytes[at]);
  }
  m_bytes.remove_prefix(bytes);
  return result;
}

namespace {
template <typename Value, typename Word> double as(std::uint64_t bits)
{
  const Word word = static_cast<Word>(bits);
  Value value;
  std::memcpy(&value, &word, sizeof(value));
  return static_cast<double>(value);
}
} // namespace

double PlyRows::binaryNumber(PlyType type)
{
  const std::uint64_t bits = word(sizeOf(type));
  switch (type) {
  case PlyType::CHAR:
    return as<std::int8_t, std::uint8_t>(bits);
  case PlyType::SHORT:
    return as<std::int16_t, std::uint16_t>(bits);
  case PlyType::INT:
    return as<std::int32_t, std::uint32_t>(bits);
  case PlyType::FLOAT:
    return as<float, std::uint32_t>(bits);
  case PlyType::DOUBLE:
    return as<double, std::uint64_t>(bits);
  default:
    return static_cast<double>(bits);
  }
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
