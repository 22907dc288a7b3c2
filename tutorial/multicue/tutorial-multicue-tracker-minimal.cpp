// SPDX-License-Identifier: GPL-2.0-or-later
//! \example tutorial-multicue-tracker-minimal.cpp
#include <visp3/core/vpPoseVector.h>
#include <visp3/io/vpVideoReader.h>
//! [Include]
#include <visp3/multicue/vpMbMultiCueTracker.h>
//! [Include]

#include <iostream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
void track(const std::string &video, const std::string &config, const std::string &model, const std::string &pose)
{
  vpImage<unsigned char> I;
  vpHomogeneousMatrix cMo;
  vpVideoReader reader;
  reader.setFileName(video);
  reader.open(I);
  //! [Tracker]
  vpMbMultiCueTracker tracker; // was: vpMbGenericTracker tracker;
  tracker.loadConfigFile(config);
  tracker.loadModel(model);
  tracker.initFromPose(I, pose);
  while (!reader.end()) {
    reader.acquire(I);
    tracker.track(I);
    tracker.getPose(cMo);
    std::cout << toString(tracker.getTrackingState()) << " " << vpPoseVector(cMo).t() << std::endl;
  }
  //! [Tracker]
}
} // namespace

int main(int argc, char *argv[])
{
  if (argc != 5) {
    std::cerr << "Usage: " << argv[0] << " <video or images%04d.png> <config.xml> <model.cao> <pose.pos>" << std::endl;
    return 1;
  }
  try {
    track(argv[1], argv[2], argv[3], argv[4]);
  } catch (const std::exception &e) {
    std::cerr << argv[0] << ": " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
