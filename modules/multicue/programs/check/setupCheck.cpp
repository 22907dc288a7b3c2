// SPDX-License-Identifier: GPL-2.0-or-later
#include "check/setupCheck.h"

#include "check/checkedCamera.h"
#include "check/checkedModel.h"
#include "check/checkedStart.h"
#include "drawing/modelDrawing.h"
#include "frames/frameReader.h"
#include "frames/imageFile.h"
#include "frames/pictureFile.h"

#include <visp3/core/vpImageConvert.h>

#include <opencv2/imgproc.hpp>

namespace programs {
namespace {
// Runs a step. \return False where it threw, which is then blamed on a topic.
template <typename Step> bool tryStep(const std::string &topic, CheckReport &report, const Step &step)
{
  try {
    step();
    return true;
  } catch (const vpException &e) {
    report.blame(topic, e.getMessage());
  } catch (const std::exception &e) {
    report.blame(topic, e.what());
  }
  return false;
}

bool load(const Setup &setup, vpMbMultiCueTracker &tracker, CheckReport &report)
{
  tracker.setModelUnit(setup.metresPerUnit);
  // The model first, so that the one of the command line goes before that of the configuration.
  const bool isLoaded = setup.model.empty() || tryStep("model", report, [&] { tracker.loadModel(setup.model); });
  const bool isConfigured = setup.config.empty() || tryStep("config", report, [&] {
                              tracker.loadConfigFile(setup.config, false);
                              for (const vpConfigReport::Item &item : tracker.getConfigReport().left) {
                                report.say("config", "left " + item.name + ": " + item.reason);
                              }
                            });
  if (isLoaded && isConfigured && !tracker.getModel()) {
    report.blame("model", "there is none: give --model, or a configuration that says one");
  }
  return isConfigured && tracker.getModel();
}

// \return The image in which tracking starts; empty where there is none.
vpImage<vpRGBa> readImage(const Setup &setup, CheckReport &report)
{
  vpImage<vpRGBa> I;
  if (!setup.image.empty()) {
    tryStep("image", report, [&] {
      ImageDepth depth;
      vpImageConvert::convert(readColorImage(setup.image, depth), I);
    });
  } else if (!setup.video.empty()) {
    FrameSource source;
    source.video = setup.video;
    if (tryStep("video", report, [&] { openFrames(source)->next(I); }) && I.getSize() == 0) {
      report.blame("video", setup.video + " has no images");
    }
  }
  return I;
}

cv::Mat toPicture(const vpImage<vpRGBa> &I)
{
  const cv::Mat color(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8UC4,
                      const_cast<vpRGBa *>(I.bitmap));
  cv::Mat picture;
  cv::cvtColor(color, picture, cv::COLOR_RGBA2BGR);
  return picture;
}

// The model over the image where it starts, with what is wrong.
cv::Mat overlay(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
                const CheckReport &report)
{
  cv::Mat picture = toPicture(I);
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  const cv::Scalar state = colorOf(report.faults.empty() ? vpTrackingState::TRACKING : vpTrackingState::LOST);
  drawModel(picture, tracker, cMo, cam, state, 2);
  const cv::Point corner(10, 22);
  drawText(picture, report.faults.empty() ? std::vector<std::string>{"no fault"} : report.faults, corner, state);
  return picture;
}

// \return The pose that is checked; none where there is none, or nothing to check it by.
std::optional<vpHomogeneousMatrix> checkPose(const Setup &setup, vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I,
                                             bool hasCamera, CheckReport &report)
{
  const std::optional<vpHomogeneousMatrix> cMo =
      setup.pose.empty() ? std::optional<vpHomogeneousMatrix>() : readStart(setup.pose, report);
  if (!cMo || !hasCamera || I.getSize() == 0) {
    return std::nullopt;
  }
  tryStep("start", report, [&] {
    if (report.faults.empty() && checkStart(tracker, I, *cMo, report)) {
      checkCues(tracker, I, *cMo, report);
    }
  });
  return cMo;
}
} // namespace

CheckReport checkSetup(const Setup &setup)
{
  CheckReport report;
  vpMbMultiCueTracker tracker;
  const bool isLoaded = load(setup, tracker, report);
  if (tracker.getModel()) {
    checkGeometry(*tracker.getModel(), report);
    checkViews(tracker.getModel(), vpModelRenderer::AUTOMATIC, report);
  }
  const vpImage<vpRGBa> I = readImage(setup, report);
  if (I.getSize() > 0) {
    checkImage(I, report);
  }
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  const bool hasCamera = isLoaded && checkCamera(cam, tracker.getConfigReport(), I, report);
  const std::optional<vpHomogeneousMatrix> cMo = checkPose(setup, tracker, I, hasCamera, report);
  if (!setup.overlay.empty() && I.getSize() > 0) {
    tryStep("overlay", report, [&] {
      writePicture(setup.overlay, cMo ? overlay(tracker, I, *cMo, report) : toPicture(I));
      report.say("overlay", setup.overlay + (cMo ? "" : ", the image alone: there is no pose to draw the model at"));
    });
  }
  return report;
}

} // namespace programs
