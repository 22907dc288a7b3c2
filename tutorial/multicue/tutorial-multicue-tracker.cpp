// SPDX-License-Identifier: GPL-2.0-or-later
//! \example tutorial-multicue-tracker.cpp
#include "frameReader.h"
#include "initFiles.h"
#include "overlayWriter.h"
#include "trackerOptions.h"
#include "trackingLog.h"

#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpIoTools.h>
#include <visp3/gui/vpDisplayX.h>
//! [Include]
#include <visp3/multicue/vpMbMultiCueTracker.h>
//! [Include]

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <memory>

namespace {
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t interrupted = 0;

double millisecondsSince(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// A window, or nothing where there is no display to open it on.
std::unique_ptr<vpDisplay> openDisplay(const TrackerOptions &options, vpImage<vpRGBa> &I)
{
#ifdef VISP_HAVE_X11
  const char *name = std::getenv("DISPLAY");
  if (options.display && name && *name) {
    try {
      return std::make_unique<vpDisplayX>(I, 50, 50, "Multi-cue tracker: click to end");
    } catch (const vpException &) {
      std::cout << "Without a window: display " << name << " cannot be opened" << std::endl;
    }
  }
#endif
  return nullptr;
}

//! [Load]
void load(vpMbMultiCueTracker &tracker, const TrackerOptions &options)
{
  tracker.loadConfigFile(options.config, false);
  tracker.setModelUnit(options.metresPerUnit);
  tracker.loadModel(options.model);
}
//! [Load]

// The points to click on are shown by ViSP, which wants a file name that ends in .init.
void initByClicks(vpMbMultiCueTracker &tracker, const std::string &file, const vpImage<vpRGBa> &I)
{
  if (vpIoTools::getFileExtension(file) != ".init" || !vpIoTools::checkFilename(file)) {
    throw vpException(vpException::ioError, "--init-click " + file + ": no such file, or its name ends not in .init");
  }
  if (!I.display) {
    throw vpException(vpException::badValue, "--init-click needs a display: use --init-pose or --init-points");
  }
  vpDisplay::display(I);
  vpDisplay::flush(I);
  tracker.initClick(I, file, true);
}

//! [Init]
void init(vpMbMultiCueTracker &tracker, const TrackerOptions &options, const vpImage<vpRGBa> &I)
{
  if (!options.initPose.empty()) {
    tracker.initFromPose(I, readPose(options.initPose));
  } else if (!options.initPoints.empty()) {
    const PointPairs points = readPoints(options.initPoints);
    tracker.initFromPoints(I, points.image, points.object);
  } else {
    initByClicks(tracker, options.initClick, I);
  }
}
//! [Init]

//! [Track]
TrackedFrame track(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, bool color)
{
  vpImage<unsigned char> gray;
  if (!color) {
    vpImageConvert::convert(I, gray);
  }
  const Clock::time_point start = Clock::now();
  if (color) {
    tracker.track(I);
  } else {
    tracker.track(gray);
  }
  TrackedFrame frame;
  frame.milliseconds = millisecondsSince(start);
  tracker.getPose(frame.cMo);
  frame.state = tracker.getTrackingState();
  return frame;
}
//! [Track]

//! [Display]
// Returns false when the user wants to end.
bool display(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const TrackedFrame &frame)
{
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  const vpColor color = frame.state == vpTrackingState::TRACKING ? vpColor::green : vpColor::red;
  vpDisplay::display(I);
  tracker.display(I, frame.cMo, cam, color, 2);
  vpDisplay::displayText(I, 20, 10, toString(frame.state), color);
  vpDisplay::flush(I);
  return !vpDisplay::getClick(I, false);
}
//! [Display]

// Prints how far it is, every two seconds at most.
void printProgress(const TrackedFrame &frame, int last)
{
  static Clock::time_point lastPrint = Clock::now();
  if (millisecondsSince(lastPrint) > 2000.) {
    lastPrint = Clock::now();
    std::cout << "frame " << frame.number << (last < 0 ? "" : " of " + std::to_string(last)) << ", "
              << toString(frame.state) << std::endl;
  }
}

void addProjectionError(TrackingLog &log, vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I,
                        const vpHomogeneousMatrix &cMo)
{
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  vpImage<unsigned char> gray;
  vpImageConvert::convert(I, gray);
  log.addProjectionError(tracker.computeCurrentProjectionError(gray, cMo, cam));
}

// Null where nothing is to be saved.
std::unique_ptr<OverlayWriter> openOverlay(const TrackerOptions &options, const FrameReader &frames)
{
  if (options.save.empty()) {
    return nullptr;
  }
  const double usual = 25.;
  const double source = frames.framesPerSecond() > 0. ? frames.framesPerSecond() : usual;
  const double saved = options.framesPerSecond > 0. ? options.framesPerSecond : source / options.step;
  return std::make_unique<OverlayWriter>(options.save, saved);
}

void run(const TrackerOptions &options)
{
  const std::unique_ptr<FrameReader> frames = openFrames(options);
  TrackingLog log(options.poses, options.summary);
  const std::unique_ptr<OverlayWriter> overlay = openOverlay(options, *frames);
  vpImage<vpRGBa> I;
  if (!frames->next(I)) {
    throw vpException(vpException::ioError, "There is no frame: is --first beyond the end?");
  }

  vpMbMultiCueTracker tracker;
  load(tracker, options);
  const std::unique_ptr<vpDisplay> window = openDisplay(options, I);
  init(tracker, options, I);

  bool goOn = true;
  do {
    TrackedFrame frame = track(tracker, I, options.color);
    frame.number = frames->number();
    log.add(frame);
    if (!options.summary.empty()) {
      addProjectionError(log, tracker, I, frame.cMo);
    }
    if (overlay) {
      overlay->write(I, tracker, frame.number);
    }
    if (window) {
      goOn = display(tracker, I, frame);
    }
    printProgress(frame, frames->last());
  } while (goOn && !interrupted && frames->next(I));

  log.finish();
  std::cout << log.summary();
  if (overlay) {
    std::cout << "saved: " << overlay->file() << std::endl;
  }
}
} // namespace

int main(int argc, char *argv[])
{
  // Ctrl-C ends the loop, so that the video and the poses are complete.
  std::signal(SIGINT, [](int) { interrupted = 1; });
  try {
    const TrackerOptions options = readOptions(argc, argv);
    if (options.help) {
      std::cout << helpText();
    } else {
      run(options);
    }
  } catch (const std::exception &e) {
    std::cerr << "tutorial-multicue-tracker: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
