// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzStart.cpp Fuzzes the files that a tracker starts from: the first byte chooses between pose and points.
#include "fuzzFile.h"
#include "fuzzModels.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
struct Tracker : vpMbMultiCueTracker
{
  Tracker() : vpMbMultiCueTracker(EDGE_TRACKER)
  {
    setCameraParameters(vpCameraParameters(80., 80., 31.5, 23.5));
    loadModel(fuzz::Models().file(0));
  }
};
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  if (size == 0) {
    return 0;
  }
  const bool isPose = data[0] % 2 == 0;
  return fuzz::readFile(isPose ? "start.pos" : "start.init", data + 1, size - 1, [isPose](const std::string &file) {
    const vpImage<unsigned char> I(48, 64, 90);
    static Tracker tracker; // Making one takes most of the time.
    if (isPose) {
      tracker.initFromPose(I, file);
    } else {
      tracker.initFromPoints(I, file);
    }
  });
}
