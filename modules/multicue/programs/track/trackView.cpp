// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/trackView.h"

#include "drawing/modelDrawing.h"

#include <visp3/core/vpImageConvert.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace programs {
namespace {
const cv::Scalar white(255, 255, 255);
// Others than those of the states.
const cv::Scalar rivals[] = {{230, 200, 0}, {0, 220, 230}, {230, 60, 230}};
// More of them hide the image.
const std::size_t mostParticles = 30;
const int particleGray = 220;       // Of one without weight; the heaviest one is black.
const std::size_t mostLetters = 72; // Of a line of text, so that it fits into 640 pixels.

vpCameraParameters cameraOf(vpMbMultiCueTracker &tracker)
{
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  return cam;
}

void drawParticles(cv::Mat &image, vpMbMultiCueTracker &tracker)
{
  std::vector<vpPoseParticle> particles = tracker.getParticles();
  std::stable_sort(particles.begin(), particles.end(),
                   [](const vpPoseParticle &a, const vpPoseParticle &b) { return a.weight > b.weight; });
  particles.resize(std::min(particles.size(), mostParticles));
  for (std::size_t i = particles.size(); i > 0; --i) { // The heaviest on top.
    const double share = std::sqrt(particles[i - 1].weight / particles.front().weight);
    drawModel(image, tracker, particles[i - 1].cMo, cameraOf(tracker), cv::Scalar::all(particleGray * (1. - share)), 1);
  }
  const std::vector<vpPoseMode> modes = tracker.getPoseModes();
  for (std::size_t i = std::min<std::size_t>(modes.size(), 3); i > 0; --i) {
    drawModel(image, tracker, modes[i - 1].cMo, cameraOf(tracker), rivals[i - 1], 2);
  }
}

void drawHypotheses(cv::Mat &image, vpMbMultiCueTracker &tracker)
{
  const std::vector<vpPoseHypothesis> &found = tracker.getPoseHypotheses();
  for (std::size_t i = std::min<std::size_t>(found.size(), 3); i > 0; --i) {
    drawModel(image, tracker, found[i - 1].cMo, cameraOf(tracker), rivals[i - 1], 1);
  }
}

// "edge 210/260, point 88/96"; the reason where a cue had no part.
std::string cueLine(const vpMbTrackingResult &result)
{
  std::string line;
  for (const vpMbTrackingResult::Cue &cue : result.cues) {
    line += (line.empty() ? "" : ", ") + cue.name + " " + std::to_string(cue.good) + "/" + std::to_string(cue.expected);
  }
  return line;
}

std::string shortened(const std::string &line)
{
  return line.size() > mostLetters ? line.substr(0, mostLetters - 3) + "..." : line;
}
} // namespace

cv::Mat TrackView::withPanel(const cv::Mat &image) const
{
  if (!m_plots) {
    return image;
  }
  cv::Mat picture;
  cv::hconcat(image, m_panel.draw(image.rows), picture);
  return picture;
}

cv::Mat TrackView::untracked(const vpImage<vpRGBa> &I, const std::vector<std::string> &text,
                             const std::vector<vpImagePoint> &marks) const
{
  cv::Mat image;
  vpImageConvert::convert(I, image);
  for (const vpImagePoint &mark : marks) {
    cv::drawMarker(image, cv::Point(cvRound(mark.get_j()), cvRound(mark.get_i())), rivals[1], cv::MARKER_CROSS, 12, 2);
  }
  drawText(image, text, {8, 20}, white);
  return withPanel(image);
}

cv::Mat TrackView::tracked(const vpImage<vpRGBa> &I, vpMbMultiCueTracker &tracker, const TrackedFrame &frame,
                           const ViewState &view)
{
  cv::Mat image;
  vpImageConvert::convert(I, image);
  if (view.particles) {
    drawParticles(image, tracker);
  }
  if (view.hypotheses) {
    drawHypotheses(image, tracker);
  }
  const cv::Scalar color = colorOf(frame.state);
  drawModel(image, tracker, frame.cMo, cameraOf(tracker), color, 2);
  if (view.features) {
    drawFeatures(image, tracker.getFeaturesForDisplay());
  }
  const vpMbTrackingResult result = tracker.getTrackingResult();
  drawText(image,
           {cv::format("%d %s, score %.2f", frame.number, toString(frame.state), frame.score),
            shortened(cueLine(result)), shortened(result.text)},
           {8, image.rows - 46}, color);
  if (!view.message.empty()) {
    drawText(image, {shortened(view.message)}, {8, 20}, white);
  }
  m_panel.add({frame.number, frame.cMo, frame.score, frame.milliseconds, frame.state});
  return withPanel(image);
}

} // namespace programs
