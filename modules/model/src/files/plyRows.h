// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef plyRows_h
#define plyRows_h

#include "files/fileBytes.h"
#include "files/plyHeader.h"

#include <cstdint>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! The data of a .ply file, row by row.
class PlyRows
{
public:
  PlyRows(const std::string &file, std::string_view bytes, const PlyHeader &header);

  //! \throw vpException where an element cannot have as many rows as the header says.
  void requireRoom(const PlyElement &element) const;
  /*!
    Reads the next row of an element.
    \param values Result: per property its number, or those of its list.
    \throw vpException where the file ends, or a text file has other words on the line.
  */
  void next(const PlyElement &element, std::vector<std::vector<double>> &values);
  //! True where nothing is left.
  bool atEnd();
  //! What is read just now, for messages: a line, or an element and its number.
  std::string place() const;

private:
  [[noreturn]] void refuse(const std::string &reason) const;
  void readLine(const PlyElement &element);
  double number(PlyType type);
  double binaryNumber(PlyType type);
  std::uint64_t word(std::size_t bytes);
  std::size_t listSize(const PlyProperty &property);

  std::string m_file;
  std::string_view m_bytes; // Of the data that is left.
  PlyHeader::Format m_format;
  std::size_t m_headerLines;
  LineWalk m_lines;
  std::string_view m_line;
  std::string m_element;
  std::size_t m_row = 0;
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
