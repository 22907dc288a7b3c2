// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/evaluateOptions.h"

#include "evaluate/benchTracker.h"
#include "program/commandLine.h"

#include <visp3/core/vpException.h>

#include <algorithm>

namespace bench {

namespace {
// A start that is farther off has nothing to do with the object.
const double mostStartError = 200.;

} // namespace

bool EvaluateOptions::read(int argc, const char *const argv[])
{
  std::string protocol = "rbot";
  programs::CommandLine line(
      "Runs trackers on sequences with ground truth and reports who holds what: tables in summary.csv\n"
      "and summary.md, pictures in report.html, every pose in runs/.\n\n"
      "A data set in BOP's or RBOT's layout:  --dataset DIR --scene NAME\n"
      "A recording of your own:               --images PATTERN --poses PATTERN --model FILE --camera FILE");
  line.add("--dataset", "folder of the data set", dataset);
  line.add("--scene", "scenes, separated by commas, or 'all'", scenes);
  line.add("--object", "number of the object in BOP's files; 0, the default: the first one of the scene", object, 0);
  line.add("--tracker", "trackers, separated by commas: " + trackerNamesText(), trackers);
  line.add("--protocol", "rbot (started again after a failure), run (never), or both; default rbot", protocol);
  line.add("--step", "every how many frames to take, separated by commas; default 1", steps);
  line.add("--config", "ViSP's XML or our JSON file, for all trackers", config);
  line.add("--cues", "cues that our trackers use, such as edge,color; default: those of each", cues);
  line.add("--threads", "threads of a tracker; default 1", threads, 1);
  line.add("--jobs", "runs side by side; times are then less exact; default 1", jobs, 1);
  line.add("--start-error",
           "how far off starts are, those after failures too, pixels in the mean over the model's points; default 0",
           start.pixels);
  line.add("--seed", "of the directions of --start-error; default 1", start.seed, 0);
  line.add("--frames", "only that many frames of each scene", frames, 2);
  line.add("--resume", "keep the runs that an earlier call with the same options finished", resume);
  line.add("--out", "folder of the results, made where it is missing", out);
  line.add("--images", "recording: printf pattern of the images", recording.images);
  line.add("--poses", "recording: printf pattern of the true poses, vpHomogeneousMatrix as text", recording.poses);
  line.add("--model", "recording: .cao, .wrl or mesh", recording.model);
  line.add("--unit", "recording: metres per unit of a mesh; default 1", recording.unit);
  line.add("--camera", "recording: ViSP's XML file with the camera", recording.camera);
  line.add("--first", "recording: number of the first image; default: the first that there is", recording.first, 0);
  line.add("--last", "recording: number of the last image; default: as many as there are", recording.last, 0);
  if (!line.read(argc, argv)) {
    return false;
  }
  setProtocols(protocol);
  check();
  return true;
}

void EvaluateOptions::setProtocols(const std::string &name)
{
  if (name == "both") {
    protocols = {Protocol::RBOT, Protocol::RUN};
  } else if (name == "rbot" || name == "run") {
    protocols = {name == "run" ? Protocol::RUN : Protocol::RBOT};
  } else {
    throw vpException(vpException::badValue, "--protocol: '%s' is not rbot, run or both", name.c_str());
  }
}

void EvaluateOptions::check() const
{
  if (hasRecording() ? recording.model.empty() || recording.poses.empty() || recording.camera.empty()
                     : dataset.empty() || scenes.empty()) {
    throw vpException(vpException::badValue, hasRecording() ? "--poses, --model and --camera are needed with --images"
                                                            : "--dataset and --scene are needed; --help says more");
  }
  if (trackers.empty() || out.empty() || steps.empty()) {
    throw vpException(vpException::badValue, "--tracker, --step and --out are needed; trackers: %s",
                      trackerNamesText().c_str());
  }
  requireTrackers(trackers);
  cuesNamed(cues);
  if (!(start.pixels >= 0. && start.pixels < mostStartError)) {
    throw vpException(vpException::badValue, "--start-error: %g is not from 0 to %g pixels", start.pixels,
                      mostStartError);
  }
  if (*std::min_element(steps.begin(), steps.end()) < 1) {
    throw vpException(vpException::badValue, "--step: steps are 1 or more");
  }
}

} // namespace bench
