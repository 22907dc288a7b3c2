// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/startOptions.h"

#include "evaluate/benchTracker.h"
#include "program/commandLine.h"

#include <visp3/core/vpException.h>

#include <algorithm>

namespace bench {

bool StartOptions::read(int argc, const char *const argv[])
{
  std::string wrongName;
  programs::CommandLine line(
      "Starts trackers at poses that are off the truth, and reports how often they find the object, and\n"
      "say so: starts.csv has every trial, summary.csv and summary.md the shares.\n\n"
      "Each trial takes an image that shows at least 0.8 of the object, turns the true pose by --angle\n"
      "about a random axis through the object's centre, shifts it by --offset in a random direction, and\n"
      "tracks that image and the ones after it. A start is accepted where the state is TRACKING then.");
  line.add("--dataset", "folder of the data set", dataset);
  line.add("--scene", "scenes, separated by commas, or 'all'", scenes);
  line.add("--tracker", "trackers of multicue-evaluate, separated by commas", trackers);
  line.add("--trials", "number of trials of each object; default 200", trials, 1);
  line.add("--seed", "of frames and directions; default 1", seed, 0);
  line.add("--angle", "of the turn, degrees; default 15", deviation.angle);
  line.add("--offset", "length of the shift, diameters; default 0.1", deviation.offset);
  line.add("--frames", "images that a trial tracks; default 10", frames, 1);
  line.add("--wrong", "starts that are to be refused: model (another object's) or scene (another object's)", wrongName);
  line.add("--basin", "in place of --angle and --offset all of 5 to 60 degrees and 0 to 0.5 diameters", basin);
  line.add("--config", "ViSP's XML or our JSON file, for all trackers", config);
  line.add("--threads", "threads of a tracker; default 1", threads, 1);
  line.add("--jobs", "objects and trackers side by side; default 1", jobs, 1);
  line.add("--out", "folder of the results, made where it is missing", out);
  if (!line.read(argc, argv)) {
    return false;
  }
  setWrong(wrongName);
  check();
  return true;
}

std::vector<StartDeviation> StartOptions::deviations() const
{
  if (!basin) {
    return {deviation};
  }
  std::vector<StartDeviation> all;
  for (const double angle : {5., 10., 15., 20., 30., 45., 60.}) {
    for (const double offset : {0., 0.1, 0.2, 0.3, 0.4, 0.5}) {
      all.push_back({angle, offset});
    }
  }
  return all;
}

void StartOptions::setWrong(const std::string &name)
{
  if (name != "" && name != "model" && name != "scene") {
    throw vpException(vpException::badValue, "--wrong: '%s' is not model or scene", name.c_str());
  }
  wrong = name.empty() ? WrongStart::NOTHING : name == "model" ? WrongStart::MODEL : WrongStart::SCENE;
}

void StartOptions::check() const
{
  if (dataset.empty() || scenes.empty() || trackers.empty() || out.empty()) {
    throw vpException(vpException::badValue, "--dataset, --scene, --tracker and --out are needed; --help says more");
  }
  requireTrackers(trackers);
  if (!(deviation.angle >= 0. && deviation.angle <= 180.)) {
    throw vpException(vpException::badValue, "--angle: %g is not within 0 and 180 degrees", deviation.angle);
  }
  if (!(deviation.offset >= 0. && deviation.offset <= 10.)) {
    throw vpException(vpException::badValue, "--offset: %g is not within 0 and 10 diameters", deviation.offset);
  }
}

} // namespace bench
