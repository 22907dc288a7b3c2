// SPDX-License-Identifier: GPL-2.0-or-later
#include "demo/demoTracker.h"

#include "drawing/modelDrawing.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <chrono>

namespace programs {
namespace {
template <typename Call> double millisecondsOf(const Call &call)
{
  const auto begin = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

template <typename Tracker> class Compared : public DemoTracker
{
public:
  void draw(cv::Mat &image, const DemoAnswer &answer) override
  {
    vpCameraParameters cam;
    m_tracker.getCameraParameters(cam);
    try {
      drawModel(image, m_tracker, answer.cMo, cam, colorOf(answer.state), 2);
    } catch (const vpException &) {
      // A lost tracker's pose may be one that cannot be drawn.
    }
  }

  double projectionError(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo) override
  {
    vpCameraParameters cam;
    m_tracker.getCameraParameters(cam);
    vpImage<unsigned char> gray;
    vpImageConvert::convert(I, gray);
    return m_tracker.computeCurrentProjectionError(gray, cMo, cam);
  }

  void start(const vpImage<vpRGBa> &I, const std::string &pose) override { m_tracker.initFromPose(I, pose); }

protected:
  template <typename... Arguments> explicit Compared(Arguments... arguments) : m_tracker(arguments...) {}

  void load(const DemoSequence &sequence)
  {
    m_tracker.loadConfigFile(sequence.config, false);
    m_tracker.loadModel(sequence.model);
  }

  Tracker m_tracker;
};

#if defined(VISP_HAVE_MODULE_KLT) && defined(VISP_HAVE_OPENCV)
const int vispFeatures = vpMbGenericTracker::EDGE_TRACKER | vpMbGenericTracker::KLT_TRACKER;
const char *const vispName = "vpMbGenericTracker, edges and KLT points";
#else
const int vispFeatures = vpMbGenericTracker::EDGE_TRACKER;
const char *const vispName = "vpMbGenericTracker, edges";
#endif

class Visp : public Compared<vpMbGenericTracker>
{
public:
  explicit Visp(const DemoSequence &sequence) : Compared(1U, vispFeatures)
  {
    load(sequence);
    m_tracker.setScanLineVisibilityTest(true); // Otherwise it sees edges that the object itself hides.
  }

  std::string name() const override { return vispName; }

  DemoAnswer track(const vpImage<vpRGBa> &I) override
  {
    DemoAnswer answer;
    answer.state = vpTrackingState::TRACKING;
    answer.milliseconds = millisecondsOf([&] {
      try {
        m_tracker.track(I);
      } catch (const vpException &) {
        answer.state = vpTrackingState::LOST; // Its way of saying so. It is asked again with the next image.
      }
    });
    m_tracker.getPose(answer.cMo);
    return answer;
  }
};

class MultiCue : public Compared<vpMbMultiCueTracker>
{
public:
  explicit MultiCue(const DemoSequence &sequence)
  {
    load(sequence);
    // Recorded images can wait. With a deadline, who holds how long would depend on what else the machine does.
    m_tracker.setFrameDeadline(0.);
  }

  std::string name() const override { return "vpMbMultiCueTracker"; }

  DemoAnswer track(const vpImage<vpRGBa> &I) override
  {
    DemoAnswer answer;
    answer.milliseconds = millisecondsOf([&] { m_tracker.track(I); });
    answer.state = m_tracker.getTrackingState();
    m_tracker.getPose(answer.cMo);
    return answer;
  }
};
} // namespace

std::unique_ptr<DemoTracker> makeVispTracker(const DemoSequence &sequence)
{
  return std::make_unique<Visp>(sequence);
}

std::unique_ptr<DemoTracker> makeMultiCueTracker(const DemoSequence &sequence)
{
  return std::make_unique<MultiCue>(sequence);
}

} // namespace programs
