// SPDX-License-Identifier: GPL-2.0-or-later
//! \example tutorial-multicue-particles.cpp
// Tracks with several cues, with particles and with a search, and draws what the tracker holds possible.
#include <visp3/core/vpImageConvert.h>
#include <visp3/io/vpVideoReader.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
void drawModel(cv::Mat &picture, vpMbMultiCueTracker &tracker, const vpHomogeneousMatrix &cMo, const cv::Scalar &color,
               int thickness)
{
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  for (const std::vector<double> &line : tracker.getModelForDisplay(
           static_cast<unsigned int>(picture.cols), static_cast<unsigned int>(picture.rows), cMo, cam)) {
    cv::line(picture, cv::Point(cvRound(line[2]), cvRound(line[1])), cv::Point(cvRound(line[4]), cvRound(line[3])),
             color, thickness, cv::LINE_AA);
  }
}

//! [Particles]
// The heaviest ones, dark where they are likely.
void drawParticles(cv::Mat &picture, vpMbMultiCueTracker &tracker)
{
  std::vector<vpPoseParticle> particles = tracker.getParticles();
  std::stable_sort(particles.begin(), particles.end(),
                   [](const vpPoseParticle &a, const vpPoseParticle &b) { return a.weight > b.weight; });
  particles.resize(std::min<std::size_t>(particles.size(), 30)); // More of them hide the image.
  for (std::size_t i = particles.size(); i > 0; --i) {
    const double share = std::sqrt(particles[i - 1].weight / particles.front().weight);
    drawModel(picture, tracker, particles[i - 1].cMo, cv::Scalar::all(220. * (1. - share)), 1);
  }
}

void drawModes(cv::Mat &picture, vpMbMultiCueTracker &tracker)
{
  const cv::Scalar colors[] = // Others than those of the state.
      {{230, 200, 0}, {0, 220, 230}, {230, 60, 230}};
  const std::vector<vpPoseMode> modes = tracker.getPoseModes();
  for (std::size_t i = std::min<std::size_t>(modes.size(), 3); i > 0; --i) {
    drawModel(picture, tracker, modes[i - 1].cMo, colors[i - 1], 2);
  }
}
//! [Particles]

cv::Scalar colorOf(vpTrackingState state)
{
  return state == vpTrackingState::TRACKING    ? cv::Scalar(80, 220, 80)
         : state == vpTrackingState::UNCERTAIN ? cv::Scalar(0, 160, 255)
                                               : cv::Scalar(60, 60, 255);
}

void write(const std::string &file, const vpImage<vpRGBa> &I, vpMbMultiCueTracker &tracker)
{
  cv::Mat image;
  vpImageConvert::convert(I, image);
  cv::Mat picture = 0.6 * image + cv::Scalar::all(100.); // Lines in gray are seen on a pale image.
  drawParticles(picture, tracker);
  drawModes(picture, tracker);
  drawModel(picture, tracker, tracker.getPose(), colorOf(tracker.getTrackingState()), 1);
  if (!cv::imwrite(file, picture)) {
    throw vpException(vpException::ioError, file + " cannot be written: is there such a folder?");
  }
}

//! [Settings]
void useAllCues(vpMbMultiCueTracker &tracker)
{
  tracker.setTrackerType(vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::COLOR_TRACKER |
                         vpMbMultiCueTracker::KLT_TRACKER);
  tracker.setPrediction(true);
  tracker.setSearch(true);
  vpParticleSettings settings;
  settings.enabled = true;
  tracker.setParticleSettings(settings);
  tracker.setDisplayParticles(true); // For display(), in programs with a window.
}
//! [Settings]

void run(const std::string &images, const std::string &model, const std::string &config, const std::string &pose,
         const std::string &folder)
{
  vpVideoReader frames;
  frames.setFileName(images);
  vpImage<vpRGBa> I;
  frames.open(I);
  vpMbMultiCueTracker tracker;
  tracker.loadConfigFile(config, false);
  tracker.loadModel(model);
  useAllCues(tracker);
  tracker.initFromPose(I, pose);

  //! [Track]
  vpTrackingState before = vpTrackingState::TRACKING;
  std::set<vpTrackingState> shown;
  while (!frames.end()) {
    frames.acquire(I);
    tracker.track(I);
    const vpTrackingState state = tracker.getTrackingState();
    if (state != before) {              // The object is hidden, lost, looked at again or found.
      if (shown.insert(state).second) { // The first picture of each state.
        write(folder + "/particles-" + toString(state) + ".jpg", I, tracker);
      }
      std::cout << "frame " << frames.getFrameIndex() << " " << toString(state) << ", " << tracker.getPoseModes().size()
                << " modes" << std::endl;
    }
    before = state;
  }
  //! [Track]
  std::cout << "at the end " << toString(before) << ", translation " << tracker.getPose().getTranslationVector().t()
            << std::endl;
}
} // namespace

int main(int argc, char *argv[])
{
  if (argc != 6) {
    std::cerr << "Usage: " << argv[0] << " <images%06d.png> <model> <config> <pose.pos> <folder of the pictures>"
              << std::endl;
    return 1;
  }
  try {
    run(argv[1], argv[2], argv[3], argv[4], argv[5]);
  } catch (const std::exception &e) {
    std::cerr << "tutorial-multicue-particles: " << e.what() << std::endl;
    return 1;
  }
  return 0;
}
