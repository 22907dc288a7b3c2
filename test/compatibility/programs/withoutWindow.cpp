// SPDX-License-Identifier: GPL-2.0-or-later
#include "withoutWindow.h"

#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpPoseVector.h>
#include <visp3/io/vpVideoReader.h>
#include <visp3/mbt/vpMbGenericTracker.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>
#include <sstream>
#include <vector>

namespace {
std::string setting(const char *name)
{
  const char *value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

unsigned long &drawn()
{
  static unsigned long count = 0;
  return count;
}

//! Says at the end how much was drawn.
struct Report
{
  ~Report() { std::cout << "Drawn: " << drawn() << std::endl; }
};
const Report report;

class Grabber
{
public:
  template <typename Pixel> void next(vpImage<Pixel> &I)
  {
    if (!m_isOpen) {
      m_video.setFileName(setting("VISP_PROGRAMS_VIDEO"));
      m_video.open(I);
      m_isOpen = true;
      return;
    }
    if (!m_video.end()) {
      m_video.acquire(I);
    }
  }
  bool isOver() { return m_isOpen && m_video.end(); }

private:
  vpVideoReader m_video;
  bool m_isOpen = false;
};

Grabber &grabber()
{
  static Grabber only;
  return only;
}

//! ViSP's own measure, of a tracker that tracks nothing.
double gradientError(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
{
  static const std::string model = setting("VISP_PROGRAMS_MODEL");
  if (model.empty()) {
    return -1.;
  }
  static std::unique_ptr<vpMbGenericTracker> tracker;
  if (!tracker) {
    tracker = std::make_unique<vpMbGenericTracker>();
    tracker->loadModel(model);
  }
  tracker->setCameraParameters(cam);
  return tracker->computeCurrentProjectionError(I, cMo, cam);
}
} // namespace

namespace withoutWindow {
vpImagePoint nextClick()
{
  static std::istringstream clicks(setting("VISP_PROGRAMS_CLICKS"));
  double u = 0.;
  double v = 0.;
  char comma = ' ';
  clicks >> u >> comma >> v;
  return vpImagePoint(v, u);
}

bool isClicked()
{
  static bool isReady = setting("VISP_PROGRAMS_READY") == "1";
  const bool isFirst = isReady;
  isReady = false;
  return isFirst || isOver();
}

bool isOver()
{
  return grabber().isOver();
}

void draw()
{
  ++drawn();
}

void grab(vpImage<unsigned char> &I)
{
  grabber().next(I);
}

void grab(vpImage<vpRGBa> &I)
{
  grabber().next(I);
}

void note(const void *tracker, const std::string &kind, const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo,
          const vpCameraParameters &cam)
{
  static std::mutex mutex; // testGenericTrackerDeterminist tracks in two threads.
  const std::lock_guard<std::mutex> lock(mutex);
  static std::ofstream file(setting("VISP_PROGRAMS_POSES"));
  file.precision(17);
  static std::vector<const void *> trackers;
  auto found = std::find(trackers.begin(), trackers.end(), tracker);
  if (found == trackers.end()) {
    found = trackers.insert(trackers.end(), tracker);
  }
  file << found - trackers.begin() << ' ' << kind;
  const vpPoseVector pose(cMo);
  for (unsigned int i = 0; i < 6; ++i) {
    file << ' ' << pose[i];
  }
  file << ' ' << gradientError(I, cMo, cam) << std::endl;
}

void note(const void *tracker, const std::string &kind, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
          const vpCameraParameters &cam)
{
  vpImage<unsigned char> gray;
  vpImageConvert::convert(I, gray);
  note(tracker, kind, gray, cMo, cam);
}
} // namespace withoutWindow
