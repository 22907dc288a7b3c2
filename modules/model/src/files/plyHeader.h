// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef plyHeader_h
#define plyHeader_h

#include <visp3/se3/vpCompatibility.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
enum class PlyType : char
{
  CHAR,
  UCHAR,
  SHORT,
  USHORT,
  INT,
  UINT,
  FLOAT,
  DOUBLE
};

//! Bytes of a number in a binary file.
std::size_t sizeOf(PlyType type);
//! What a colour of this type is divided by.
double colorScale(PlyType type);

struct PlyProperty
{
  std::string name;
  PlyType type = PlyType::FLOAT;
  bool isList = false;
  PlyType countType = PlyType::UCHAR; //!< Of a list.
};

struct PlyElement
{
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  //! \return Index of the first property with one of these names, -1 where there is none.
  int find(const std::vector<const char *> &names) const;
};

//! What a .ply file says of itself before its data.
struct PlyHeader
{
  enum Format
  {
    ASCII,
    LITTLE,
    BIG
  };

  Format format = ASCII;
  std::vector<PlyElement> elements;
  std::vector<std::string> images; //!< Texture files that its comments name.
  std::size_t lines = 0;           //!< Of the header.
  std::size_t dataStart = 0;       //!< Byte after the header.

  //! \throw vpException naming the file where the header is not whole, or the line that is wrong.
  static PlyHeader read(const std::string &file, std::string_view bytes);
};
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
