// SPDX-License-Identifier: GPL-2.0-or-later
#include "check/checkedStart.h"

#include "check/likelyCause.h"
#include "track/startFiles.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace programs {
namespace {
// Smaller objects have edges that are closer together than masks are wide, pixels.
constexpr double smallest = 25.;
// Share of the object's box that has to be in the image.
constexpr double leastInside = 0.4;
// Of vpMbMultiCueTracker::score(): a right pose is as likely as a wrong one.
constexpr double seen = 0.5;
constexpr double fullTurn = 6.2831853071795865;

// The box around an object in the image, pixels, and its depths, metres.
struct Box
{
  double left = HUGE_VAL, right = -HUGE_VAL, top = HUGE_VAL, bottom = -HUGE_VAL;
  double nearest = HUGE_VAL, farthest = -HUGE_VAL;

  Box(const vpTrackedModel &model, const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo)
  {
    for (unsigned int corner = 0; corner < 8; ++corner) {
      vpColVector p(4, 1.);
      for (unsigned int i = 0; i < 3; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        p[i] = (corner & (1U << i)) != 0 ? model.boxMax()[k] : model.boxMin()[k];
      }
      const vpColVector c = cMo * p;
      nearest = std::min(nearest, c[2]);
      farthest = std::max(farthest, c[2]);
      const double u = cam.get_u0() + cam.get_px() * c[0] / c[2], v = cam.get_v0() + cam.get_py() * c[1] / c[2];
      left = std::min(left, u);
      right = std::max(right, u);
      top = std::min(top, v);
      bottom = std::max(bottom, v);
    }
  }

  double size() const { return std::max(right - left, bottom - top); }
  double insideShare(double width, double height) const
  {
    const double w = std::min(right, width) - std::max(left, 0.), h = std::min(bottom, height) - std::max(top, 0.);
    return std::max(w, 0.) * std::max(h, 0.) / ((right - left) * (bottom - top));
  }
  std::string text() const
  {
    return printed("columns %.0f", left) + printed(" to %.0f", right) + printed(", rows %.0f", top) +
           printed(" to %.0f", bottom);
  }
};

// What keeps a camera from seeing it; empty where nothing does.
std::string geometryFault(const Box &box, double diameter, double width, double height)
{
  if (box.farthest <= 0.) {
    return printed("the object is behind the camera, z %.3g m", box.nearest) +
           ": poses map object to camera, z forward";
  }
  if (box.nearest <= 0.) {
    return "the camera is inside the object's box, which is " + lengthText(diameter) + " from corner to corner" +
           printed(", %.3g m away", 0.5 * (box.nearest + box.farthest)) + ": check unit and pose";
  }
  if (box.size() < smallest) {
    return printed("the object is too small in the image: %.1f pixels", box.size()) + ", " + lengthText(diameter) +
           printed(" at a distance of %.3g m", box.nearest) + "; check unit and pose";
  }
  const double inside = box.insideShare(width, height);
  if (!(inside > leastInside)) {
    return printed("%.0f %% of the object's box is in the image", 100. * inside) + " (" + box.text() + " of " +
           printed("%.0f x ", width) + printed("%.0f)", height) + ": check pose and camera";
  }
  return "";
}

// A start that was clicked is some pixels off: of the pose that tracking begins at, where that is about as near.
double scoreNear(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo)
{
  constexpr double mostOffset = 12.; // Pixels; three times as far off as a start that is clicked.
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  tracker.setSearch(false);
  tracker.initFromPose(I, cMo);
  tracker.track(I);
  const vpHomogeneousMatrix found = tracker.getPose();
  tracker.initFromPose(I, cMo); // Forgets what was learnt there.
  const Box given(*tracker.getModel(), cam, cMo), there(*tracker.getModel(), cam, found);
  const double offset = std::max({std::abs(given.left - there.left), std::abs(given.right - there.right),
                                  std::abs(given.top - there.top), std::abs(given.bottom - there.bottom)});
  return offset < mostOffset ? tracker.score(I, found) : 0.;
}

double rotationOf(const std::string &file)
{
  std::ifstream stream(file);
  std::vector<double> numbers;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    words.imbue(std::locale::classic());
    for (double number; words >> number;) {
      numbers.push_back(number);
    }
  }
  return numbers.size() == 6 ? std::hypot(numbers[3], numbers[4], numbers[5]) : 0.;
}
} // namespace

std::optional<vpHomogeneousMatrix> readStart(const std::string &file, CheckReport &report)
{
  try {
    const vpHomogeneousMatrix cMo = readPose(file);
    if (rotationOf(file) > fullTurn) {
      report.blame("start", file + printed(": its rotation is %.4g radians", rotationOf(file)) +
                                ", more than a turn: theta u is to be in radians, not in degrees");
      return std::nullopt;
    }
    return cMo;
  } catch (const vpException &e) {
    report.blame("start", e.getMessage());
    return std::nullopt;
  }
}

bool checkStart(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
                CheckReport &report)
{
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  const Box box(*tracker.getModel(), cam, cMo);
  const std::string fault = geometryFault(box, tracker.getModel()->diameter(), I.getWidth(), I.getHeight());
  if (!fault.empty()) {
    const std::string cause = likelyCause(tracker, I, cMo);
    report.blame("start", fault + (cause.empty() ? "" : "; " + cause));
    return false;
  }
  report.say("start", printed("%.3g m away", cMo[2][3]) + ", " + box.text());
  const double score = std::max(tracker.score(I, cMo), scoreNear(tracker, I, cMo));
  report.say("start", printed("the image shows the object there with a probability of %.2f", score));
  if (score < seen) {
    const std::string cause = likelyCause(tracker, I, cMo);
    report.blame("start", "the image does not show the object at the start pose" +
                              (cause.empty() ? ": check pose, model and camera by the overlay" : "; " + cause));
  }
  return score >= seen;
}

void checkCues(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
               CheckReport &report)
{
  tracker.setSearch(false);
  tracker.initFromPose(I, cMo);
  constexpr int frames = 3; // Colours and points are learnt in the first.
  for (int frame = 0; frame < frames; ++frame) {
    tracker.track(I);
  }
  for (const vpMbTrackingResult::Cue &cue : tracker.getTrackingResult().cues) {
    const double share = cue.expected > 0 ? 100. * cue.good / cue.expected : 0.;
    report.say("cue " + cue.name, cue.reason.empty()
                                      ? std::to_string(cue.good) + " of " + std::to_string(cue.expected) +
                                            printed(" features are used, %.0f %%", share)
                                      : "cannot be used: " + cue.reason);
  }
}

} // namespace programs
