// SPDX-License-Identifier: GPL-2.0-or-later
#include "disturb/disturbOptions.h"

#include "evaluate/benchTracker.h"
#include "program/commandLine.h"

#include <visp3/core/vpException.h>

#include <algorithm>

namespace bench {

bool DisturbOptions::read(int argc, const char *const argv[])
{
  programs::CommandLine line(
      "Starts trackers at poses that are some pixels off, and shifts images under them while they track; tells how\n"
      "often the pose is right in the end, and how often it is wrong though the state says TRACKING.\n\n"
      "A scene of a data set in BOP's or RBOT's layout:  --dataset DIR --scene NAME\n"
      "A recording:  --images PATTERN --model FILE --config FILE, and --poses PATTERN or --start FILE");
  line.add("--dataset", "folder of the data set", dataset);
  line.add("--scene", "one scene", scene);
  line.add("--images", "recording: printf pattern of the images, or a video", images);
  line.add("--first", "recording: number of the first image; default: the first that there is", first, 0);
  line.add("--last", "recording: number of the last image; default: as many as there are", last, 0);
  line.add("--poses", "recording: printf pattern of the true poses, vpHomogeneousMatrix as text", poses);
  line.add("--start", "recording: the first pose, 6 numbers as in ViSP's .pos files; --follower gives the others",
           start);
  line.add("--follower",
           "recording: trackers, separated by commas; from --start, the poses of the first are true where all agree; "
           "default visp-edge,multicue",
           followers);
  line.add("--model", "recording: .cao, .wrl or mesh", model);
  line.add("--unit", "recording: metres per unit of a mesh; default 1", unit);
  line.add("--config", "ViSP's XML or our JSON file for all trackers; of a recording, it has the camera", config);
  line.add("--tracker", "trackers of multicue-evaluate, separated by commas", trackers);
  line.add("--offset", "how far off starts are, pixels in the mean over the model's points; default 2,4,6,10", offsets);
  line.add("--shift", "how far images are shifted, pixels; default 20,26,32,40,52,68,86,105,126; 0: not", shifts);
  line.add("--trials", "starts of each offset; default 100", trials, 1);
  line.add("--frames", "images that a start is followed for; default 10", frames, 1);
  line.add("--frames-after", "images that a shift is followed for; default 5", framesAfter, 1);
  line.add("--right", "pixels that the model's points may be off in the end, in the mean; default 2.5", right);
  line.add("--gray", "images without their colours", gray);
  line.add("--seed", "of frames and directions; default 1", seed, 0);
  if (!line.read(argc, argv)) {
    return false;
  }
  check();
  return true;
}

void DisturbOptions::check() const
{
  if (images.empty() && (dataset.empty() || scene.empty())) {
    throw vpException(vpException::badValue, "--images, or --dataset and --scene are needed; --help says more");
  }
  if (!images.empty() && (model.empty() || config.empty() || poses.empty() == start.empty())) {
    throw vpException(vpException::badValue,
                      "--model, --config and one of --poses and --start are needed with --images");
  }
  if (trackers.empty() || followers.empty()) {
    throw vpException(vpException::badValue, "--tracker is needed, and --follower must name one tracker at least");
  }
  std::vector<std::string> named = trackers;
  named.insert(named.end(), followers.begin(), followers.end());
  requireTrackers(named);
  if (!(right > 0.)) {
    throw vpException(vpException::badValue, "--right: %g is not above 0", right);
  }
}

} // namespace bench
