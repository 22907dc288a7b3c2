// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef modelErrors_h
#define modelErrors_h

#include <visp3/core/vpException.h>
#include <visp3/se3/vpCompatibility.h>

#include <string>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
[[noreturn]] inline void refuse(const std::string &text)
{
  throw vpException(vpException::badValue, "%s", text.c_str());
}

//! A primitive as messages call it: "polygon 3 'lid'".
inline std::string describe(const std::string &kind, const std::string &name, int polygon)
{
  return kind + (polygon >= 0 ? " " + std::to_string(polygon) : "") + (name.empty() ? "" : " '" + name + "'");
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
