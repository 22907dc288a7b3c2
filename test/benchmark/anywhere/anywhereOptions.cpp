// SPDX-License-Identifier: GPL-2.0-or-later
#include "anywhere/anywhereOptions.h"

#include "evaluate/benchTracker.h"
#include "program/commandLine.h"

#include <visp3/core/vpException.h>

namespace bench {

bool AnywhereOptions::read(int argc, const char *const argv[])
{
  programs::CommandLine line(
      "Starts trackers without a pose, in single images, and tells how often they find the object, how often they are\n"
      "wrong and say nothing, and how long that takes.");
  line.add("--dataset", "folder of the data set", dataset);
  line.add("--scene", "scenes, separated by commas, or 'all'", scenes);
  line.add("--tracker", "a tracker of ours, see multicue-evaluate; default robust", tracker);
  line.add("--config", "ViSP's XML or our JSON file", config);
  line.add("--every", "every how many frames are looked at; default 5", every, 1);
  line.add("--most", "images of each object at most, spread over its scenes", most, 1);
  line.add("--follow", "images that are tracked after a start that was accepted; default 0", follow, 0);
  line.add("--absent", "look for each object in the images of the others: all should be refused", absent);
  line.add("--gray", "gray images", gray);
  line.add("--nearest", "least distance of the object, metres; default the tracker's", nearest);
  line.add("--farthest", "largest distance of the object, metres; default the tracker's", farthest);
  line.add("--overlays", "folder for pictures of each start that was not right", overlays);
  if (!line.read(argc, argv)) {
    return false;
  }
  if (dataset.empty() || scenes.empty()) {
    throw vpException(vpException::badValue, "--dataset and --scene are needed; --help says more");
  }
  requireTrackers({tracker});
  return true;
}

} // namespace bench
