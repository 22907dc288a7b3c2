// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/benchTracker.h"

#include "evaluate/multiCueBenchTracker.h"
#include "evaluate/vispBenchTracker.h"

#include <visp3/core/vpException.h>

#include <algorithm>

namespace bench {

namespace {
bool contains(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}
} // namespace

void BenchTracker::startRoughly(const BenchImage &I, const vpHomogeneousMatrix &cMo, double, double)
{
  init(I, cMo);
}

std::vector<std::string> trackerNames()
{
  std::vector<std::string> names = multiCuePresets();
  const std::vector<std::string> visp = vispTrackers();
  names.insert(names.end(), visp.begin(), visp.end());
  return names;
}

bool needsCao(const std::string &name)
{
  return contains(vispTrackers(), name);
}

std::unique_ptr<BenchTracker> makeTracker(const std::string &name, const SequenceObject &object,
                                          const vpCameraParameters &cam, const std::string &config)
{
  if (contains(multiCuePresets(), name)) {
    return makeMultiCueTracker(name, object, cam, config);
  }
  if (!contains(vispTrackers(), name)) {
    std::string known;
    for (const std::string &other : trackerNames()) {
      known += " " + other;
    }
    throw vpException(vpException::badValue, "Tracker '%s' is not known; there are%s", name.c_str(), known.c_str());
  }
  if (object.cao.empty()) {
    throw vpException(vpException::badValue, "%s needs a .cao model, and object %d has none beside its mesh",
                      name.c_str(), object.id);
  }
  return makeVispTracker(name, object, cam, config);
}

} // namespace bench
