// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/lengthUnit.h"

#include <visp3/core/vpException.h>

#include <map>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

double metresPerUnit(const std::string &unit)
{
  const std::map<std::string, double> metres = {{"m", 1.}, {"cm", 0.01}, {"mm", 0.001}, {"inch", 0.0254}};
  const auto found = metres.find(unit);
  if (found == metres.end()) {
    throw vpException(vpException::badValue, "--unit knows m, cm, mm and inch, but got \"" + unit + "\" (see --help)");
  }
  return found->second;
}

} // namespace programs
