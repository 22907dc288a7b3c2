// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/variants.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <sstream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
// The parts of a variant that is joined of several.
std::vector<std::string> partsOf(const std::string &variant)
{
  std::vector<std::string> parts;
  std::istringstream text(variant);
  for (std::string part; std::getline(text, part, '+');) {
    parts.push_back(part);
  }
  return parts;
}
} // namespace

std::vector<std::string> variantNames()
{
  return {"regular", "light", "noise", "occlusion", "blur", "blackout", "exit", "webcam"};
}

bool hasVariant(const std::string &variant, const std::string &name)
{
  const std::vector<std::string> parts = partsOf(variant);
  return std::find(parts.begin(), parts.end(), name) != parts.end();
}

void checkVariant(const std::string &variant)
{
  const std::vector<std::string> names = variantNames();
  for (const std::string &part : partsOf(variant)) {
    if (std::find(names.begin(), names.end(), part) == names.end()) {
      std::string all;
      for (const std::string &name : names) {
        all += " " + name;
      }
      throw vpException(vpException::badValue, "there is no variant '%s', only:%s; several are joined by +",
                        part.c_str(), all.c_str());
    }
  }
}

} // namespace bench
