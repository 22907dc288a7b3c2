// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/syntheticObject.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelReader.h>

#include <algorithm>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
struct Maker
{
  const char *name;
  SyntheticObject (*make)(std::uint64_t seed);
};
const Maker makers[] = {{"box", makeBox},
                        {"bands", makeBands},
                        {"window", makeWindow},
                        {"satellite", makeSatellite},
                        {"figurine", makeFigurine}};
} // namespace

std::vector<std::string> objectNames()
{
  std::vector<std::string> names;
  for (const Maker &maker : makers) {
    names.emplace_back(maker.name);
  }
  return names;
}

SyntheticObject makeObject(const std::string &name, std::uint64_t seed, double unit)
{
  for (const Maker &maker : makers) {
    if (name == maker.name) {
      return maker.make(seed);
    }
  }
  if (vpModelReader::isMesh(name)) {
    return makeFromMesh(name, unit);
  }
  std::string all;
  for (const std::string &known : objectNames()) {
    all += " " + known;
  }
  throw vpException(vpException::badValue, "there is no object '%s', only:%s; or give the path of a mesh file",
                    name.c_str(), all.c_str());
}

} // namespace bench
