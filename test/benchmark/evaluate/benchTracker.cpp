// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/benchTracker.h"

#include "evaluate/multiCueBenchTracker.h"
#include "evaluate/vispBenchTracker.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpCueKind.h>

#include <algorithm>

namespace bench {

namespace {
bool contains(const std::vector<std::string> &names, const std::string &name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string toText(const std::vector<std::string> &names)
{
  std::string text;
  for (const std::string &name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}
} // namespace

void BenchTracker::startRoughly(const BenchImage &I, const vpHomogeneousMatrix &cMo, double, double)
{
  init(I, cMo);
}

bool BenchTracker::startAnywhere(const BenchImage &, double, double)
{
  throw vpException(vpException::badValue, "This tracker needs a pose to start at: take one of %s",
                    toText(multiCuePresets()).c_str());
}

std::vector<std::string> trackerNames()
{
  std::vector<std::string> names = multiCuePresets();
  const std::vector<std::string> visp = vispTrackers();
  names.insert(names.end(), visp.begin(), visp.end());
  return names;
}

std::string trackerNamesText()
{
  return toText(trackerNames());
}

void requireTrackers(const std::vector<std::string> &names)
{
  const std::vector<std::string> known = trackerNames();
  for (const std::string &name : names) {
    if (!contains(known, name)) {
      throw vpException(vpException::badValue, "--tracker: '%s' is not one of %s", name.c_str(),
                        trackerNamesText().c_str());
    }
  }
}

int cuesNamed(const std::vector<std::string> &names)
{
  int cues = 0;
  for (const std::string &name : names) {
    const std::deque<vpCueKind> &kinds = vpCueKinds::all();
    const auto kind =
        std::find_if(kinds.begin(), kinds.end(), [&name](const vpCueKind &one) { return one.name == name; });
    if (kind == kinds.end()) {
      std::string known;
      for (const vpCueKind &one : kinds) {
        known += (known.empty() ? "" : ", ") + one.name;
      }
      throw vpException(vpException::badValue, "--cues: '%s' is not one of %s", name.c_str(), known.c_str());
    }
    cues |= kind->type;
  }
  return cues;
}

bool needsCao(const std::string &name)
{
  return contains(vispTrackers(), name);
}

std::unique_ptr<BenchTracker> makeTracker(const std::string &name, const SequenceObject &object,
                                          const vpCameraParameters &cam, const std::string &config, int cues)
{
  if (contains(multiCuePresets(), name)) {
    return makeMultiCueTracker(name, object, cam, config, cues);
  }
  requireTrackers({name});
  if (object.cao.empty()) {
    throw vpException(vpException::badValue, "%s needs a .cao model, and object %d has none beside its mesh",
                      name.c_str(), object.id);
  }
  return makeVispTracker(name, object, cam, config);
}

} // namespace bench
