// SPDX-License-Identifier: GPL-2.0-or-later
//! \example tutorial-multicue-tracker.cpp
// Tracks an object in a window, and says how far to believe the pose and why.
#include <visp3/core/vpIoTools.h>
#include <visp3/gui/vpDisplayX.h>
#include <visp3/io/vpVideoReader.h>
//! [Include]
#include <visp3/multicue/vpMbMultiCueTracker.h>
//! [Include]

#include <iostream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
//! [Start]
// A .pos file holds the pose in the first image, an .init file points of the model to click on.
void start(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const std::string &file)
{
  if (vpIoTools::getFileExtension(file) == ".init") {
    vpDisplay::display(I);
    vpDisplay::flush(I);
    tracker.initClick(I, file, true);
  } else {
    tracker.initFromPose(I, file);
  }
}
//! [Start]

//! [Display]
void display(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I)
{
  const vpMbTrackingResult result = tracker.getTrackingResult();
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  const vpColor color = result.state == vpTrackingState::TRACKING ? vpColor::green : vpColor::red;
  vpDisplay::display(I);
  tracker.display(I, result.cMo, cam, color, 2);
  vpDisplay::displayText(I, 20, 10, std::string(toString(result.state)) + ": " + result.text, color);
  vpDisplay::flush(I);
}
//! [Display]

void run(const std::string &video, const std::string &config, const std::string &model, const std::string &startFile)
{
  vpVideoReader reader;
  reader.setFileName(video);
  vpImage<vpRGBa> I;
  reader.open(I);
#ifdef VISP_HAVE_X11
  vpDisplayX window(I, 50, 50, "Click to end");
#endif
  //! [Load]
  vpMbMultiCueTracker tracker; // with the preset ROBUST
  tracker.loadConfigFile(config, false);
  tracker.loadModel(model);
  //! [Load]
  start(tracker, I, startFile);
  //! [Track]
  while (!reader.end() && !vpDisplay::getClick(I, false)) {
    reader.acquire(I);
    tracker.track(I);
    display(tracker, I);
    std::cout << toString(tracker.getTrackingState()) << " " << tracker.getTrackingResult().score << std::endl;
  }
  //! [Track]
}
} // namespace

int main(int argc, char *argv[])
{
  if (argc != 5) {
    std::cerr << "Usage: " << argv[0] << " <video or images%04d.png> <config> <model> <pose.pos or points.init>"
              << std::endl;
    return 1;
  }
  try {
    run(argv[1], argv[2], argv[3], argv[4]);
  } catch (const std::exception &e) {
    std::cerr << argv[0] << ": " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
