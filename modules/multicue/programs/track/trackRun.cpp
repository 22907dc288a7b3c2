// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/trackRun.h"

#include "frames/grayOrColor.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpCueKind.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <thread>

namespace programs {
namespace {
volatile std::sig_atomic_t interrupted = 0;

const double usualFramesPerSecond = 25.; // Where the source does not tell.
const std::chrono::seconds printInterval(2);

double framesPerSecond(const TrackOptions &options, const FrameReader &frames)
{
  const double source = frames.framesPerSecond() > 0. ? frames.framesPerSecond() : usualFramesPerSecond;
  return options.framesPerSecond > 0. ? options.framesPerSecond : source / options.source.step;
}

int cueTypes(const std::vector<std::string> &names)
{
  int types = 0;
  for (const std::string &name : names) {
    const auto &all = vpCueKinds::all();
    const auto kind = std::find_if(all.begin(), all.end(), [&name](const vpCueKind &k) { return k.name == name; });
    if (kind == all.end()) {
      throw vpException(vpException::badValue, "--cues: '%s' is no cue; there are %s", name.c_str(),
                        vpCueKinds::listText().c_str());
    }
    types |= kind->type;
  }
  return types;
}
} // namespace

TrackRun::TrackRun(const TrackOptions &options)
    : m_options(options), m_frames(openFrames(m_options.source)), m_view(!options.noPlots),
      m_log(options.poses, options.summary)
{
  if (!nextFrame()) {
    throw vpException(vpException::ioError, "There is no frame: is --first beyond the end?");
  }
  setUpTracker();
  openOutputs();
}

// The model of the command line first: that of the configuration is left out where there is one. What is typed counts
// more than what was written.
void TrackRun::loadModelAndConfig()
{
  if (!m_options.model.empty()) {
    const vpMultiCueSettings settings = vpMultiCueSettingsReader::read(m_options.config, vpMultiCueSettings());
    if (settings.modelFile.empty()) { // Else its unit is that of the other model.
      m_tracker.setModelOptions(settings.model);
    }
  }
  if (m_options.metresPerUnit > 0.) {
    m_tracker.setModelUnit(m_options.metresPerUnit);
  }
  if (!m_options.model.empty()) {
    m_tracker.loadModel(m_options.model);
  }
  m_tracker.loadConfigFile(m_options.config, false);
  if (!m_tracker.getModel()) {
    throw vpException(vpException::badValue, "--model is missing, and %s says no model", m_options.config.c_str());
  }
}

void TrackRun::setUpTracker()
{
  loadModelAndConfig();
  if (!m_options.preset.empty()) { // After the file: what is typed counts more than what was written.
    m_tracker.setPreset(vpMultiCuePresetFromString(m_options.preset));
  }
  if (!m_options.cues.empty()) {
    m_tracker.setTrackerType(cueTypes(m_options.cues));
  }
  m_starter = std::make_unique<Starter>(m_options, m_tracker);
  m_state.hypotheses = m_tracker.getPoseHypothesisSettings().enabled;
  m_state.particles = m_tracker.getParticleSettings().enabled;
}

void TrackRun::openOutputs()
{
  if (!m_options.save.empty()) {
    m_video = std::make_unique<VideoFile>("--save", m_options.save, framesPerSecond(m_options, *m_frames));
  }
  if (!m_options.record.empty()) {
    vpCameraParameters cam;
    m_tracker.getCameraParameters(cam);
    m_recorder = std::make_unique<Recorder>(m_options.record, cam, *m_tracker.getModel(), m_options.model);
  }
  if (!m_options.noDisplay) {
    m_window = TrackWindow::open(m_view.untracked(m_image, {}).size());
  }
}

void TrackRun::stop()
{
  interrupted = 1;
}

bool TrackRun::nextFrame()
{
  return m_frames->next(m_image);
}

bool TrackRun::findStart()
{
  while (!m_starter->start(m_image, m_window.get(), m_view)) {
    const cv::Mat picture = m_view.untracked(m_image, {"waiting for the start"});
    if (!show(picture) || interrupted || !nextFrame()) {
      return false;
    }
  }
  return true;
}

TrackedFrame TrackRun::track()
{
  TrackedFrame frame;
  inGrayOrColor(m_image, m_options.gray, [&](const auto &image) {
    const Clock::time_point begin = Clock::now();
    m_tracker.track(image);
    frame.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  });
  const vpMbTrackingResult result = m_tracker.getTrackingResult();
  frame.number = m_frames->number();
  frame.cMo = result.cMo;
  frame.state = result.state;
  frame.score = result.score;
  return frame;
}

void TrackRun::writeOut(const TrackedFrame &frame, const cv::Mat &picture)
{
  m_log.add(frame);
  if (!m_options.summary.empty()) {
    vpCameraParameters cam;
    m_tracker.getCameraParameters(cam);
    m_log.addProjectionError(m_tracker.computeCurrentProjectionError(m_image, frame.cMo, cam));
  }
  if (m_recorder) {
    m_recorder->add(m_image, frame);
  }
  if (m_video) {
    m_video->write(picture, frame.number);
  }
}

void TrackRun::waitForFrameTime()
{
  if (m_options.fullSpeed || m_options.source.camera >= 0) {
    return;
  }
  const double seconds = 1. / framesPerSecond(m_options, *m_frames);
  std::this_thread::sleep_until(m_frameTime +
                                std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds)));
  m_frameTime = Clock::now();
}

bool TrackRun::show(const cv::Mat &picture)
{
  if (!m_window) {
    return true;
  }
  waitForFrameTime();
  m_window->show(picture);
  m_state.step = false;
  do {
    const std::string key = m_window->key(m_state.paused);
    applyKey(key, m_tracker, m_state);
    if (m_state.restart) {
      startAgain();
    }
  } while (m_state.paused && !m_state.step && !m_state.quit && !interrupted);
  return !m_state.quit;
}

void TrackRun::startAgain()
{
  m_state.restart = false;
  try {
    m_state.message = m_starter->startAgain(m_image, m_window.get(), m_view) ? "started anew" : "no start found";
  } catch (const vpException &e) {
    m_state.message = e.getStringMessage(); // The tracker goes on from its last good pose.
  }
}

void TrackRun::printProgress(const TrackedFrame &frame)
{
  if (Clock::now() - m_lastPrint > printInterval) {
    m_lastPrint = Clock::now();
    const int last = m_frames->last();
    std::cout << "frame " << frame.number << (last < 0 ? "" : " of " + std::to_string(last)) << ", "
              << toString(frame.state) << std::endl;
  }
}

void TrackRun::trackFrames()
{
  bool goesOn = true;
  while (goesOn) {
    const TrackedFrame frame = track();
    cv::Mat picture;
    if (m_video || m_window) {
      picture = m_view.tracked(m_image, m_tracker, frame, m_state);
    }
    writeOut(frame, picture);
    printProgress(frame);
    goesOn = show(picture) && !interrupted && nextFrame();
  }
}

void TrackRun::run()
{
  if (!findStart()) {
    throw vpException(vpException::fatalError, "The object was not found in any image: no start");
  }
  std::exception_ptr failure;
  try {
    trackFrames();
  } catch (const std::exception &) {
    failure = std::current_exception(); // Of a camera that was unplugged, say: what was tracked until then is kept.
  }
  m_log.finish();
  if (m_recorder) {
    m_recorder->finish();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
  std::cout << m_log.summary();
  if (m_video) {
    std::cout << "saved: " << m_video->file() << std::endl;
  }
}

} // namespace programs
