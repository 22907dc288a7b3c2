// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsTrackRun_h
#define programsTrackRun_h

#include "frames/videoFile.h"
#include "track/recorder.h"
#include "track/starter.h"

#include <chrono>

namespace programs {

//! One run of multicue-track: from the first image to the last one, or until the user ends it.
class TrackRun
{
public:
  //! Opens everything that the options name. \throw vpException naming what cannot be opened.
  explicit TrackRun(const TrackOptions &options);

  void run();
  //! Ends run() after the image that is tracked; for signals.
  static void stop();

private:
  using Clock = std::chrono::steady_clock;

  void loadModelAndConfig();
  void setUpTracker();
  void openOutputs();
  //! Shows images until one tells where the object is. \return False at the end of the images.
  bool findStart();
  //! To the end of the images, or until the user ends it.
  void trackFrames();
  TrackedFrame track();
  void writeOut(const TrackedFrame &frame, const cv::Mat &picture);
  //! Shows a picture and does what keys say. \return False where the run ends.
  bool show(const cv::Mat &picture);
  void startAgain();
  void waitForFrameTime();
  bool nextFrame();
  void printProgress(const TrackedFrame &frame);

  TrackOptions m_options;
  std::unique_ptr<FrameReader> m_frames;
  vpMbMultiCueTracker m_tracker;
  TrackView m_view;
  ViewState m_state;
  TrackingLog m_log;
  std::unique_ptr<Starter> m_starter;
  std::unique_ptr<VideoFile> m_video;    //!< Null where nothing is saved.
  std::unique_ptr<Recorder> m_recorder;  //!< Null where nothing is recorded.
  std::unique_ptr<TrackWindow> m_window; //!< Null where there is none.
  vpImage<vpRGBa> m_image;
  Clock::time_point m_lastPrint = Clock::now();
  Clock::time_point m_frameTime = Clock::now(); //!< When the last frame was shown.
};

} // namespace programs
#endif
