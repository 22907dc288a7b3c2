// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/starter.h"

#include "frames/grayOrColor.h"
#include "track/startFiles.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>

#include <sstream>

namespace programs {

Starter::Starter(const TrackOptions &options, vpMbMultiCueTracker &tracker) : m_options(options), m_tracker(tracker)
{
  const StartOptions &start = options.start;
  if (!start.click.empty()) {
    m_clickPoints = readClickPoints(start.click);
  }
  if (start.tag >= 0) {
    const vpHomogeneousMatrix oMt = start.tagPose.empty() ? vpHomogeneousMatrix() : readPose(start.tagPose);
    m_tag = std::make_shared<TagFinder>(start.tag, start.tagSize, oMt);
    tracker.setDetector(
        [tag = m_tag](const vpImage<vpRGBa> &I, const vpCameraParameters &cam) { return tag->find(I, cam); });
  }
}

bool Starter::about(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpPoseDeviation &deviation)
{
  // Where it is refused, the tracker's state says so, and it looks for the object in the next images.
  inGrayOrColor(I, m_options.gray, [&](const auto &image) { m_tracker.initFromRoughPose(image, cMo, deviation); });
  return true;
}

bool Starter::anywhere(const vpImage<vpRGBa> &I)
{
  vpDistanceRange distances;
  distances.nearest = m_options.start.nearest;
  distances.farthest = m_options.start.farthest;
  bool isFound = false;
  inGrayOrColor(I, m_options.gray, [&](const auto &image) { isFound = m_tracker.initFromImage(image, distances); });
  return isFound;
}

bool Starter::byTag(const vpImage<vpRGBa> &I)
{
  vpCameraParameters cam;
  m_tracker.getCameraParameters(cam);
  const std::vector<vpWeightedPose> found = m_tag->find(I, cam);
  if (found.empty()) {
    return false;
  }
  inGrayOrColor(I, m_options.gray, [&](const auto &image) { m_tracker.initFromPose(image, found.front().cMo); });
  return true;
}

bool Starter::byClicks(const vpImage<vpRGBa> &I, TrackWindow *window, const TrackView &view)
{
  if (window == nullptr) {
    throw vpException(vpException::badValue,
                      "--init-click needs a window: use --init-pose, --init-points, --init-rough or --init-anywhere");
  }
  std::vector<vpImagePoint> clicked;
  for (const vpPoint &point : m_clickPoints) {
    std::ostringstream text;
    text << "Click on point " << clicked.size() + 1 << " of " << m_clickPoints.size() << ": " << point.get_oX() << " "
         << point.get_oY() << " " << point.get_oZ() << " m";
    window->show(view.untracked(I, {text.str(), "another button: take the next image"}, clicked));
    vpImagePoint pixel;
    if (!window->click(pixel)) {
      return false;
    }
    clicked.push_back(pixel);
  }
  inGrayOrColor(I, m_options.gray, [&](const auto &image) { m_tracker.initFromPoints(image, clicked, m_clickPoints); });
  return true;
}

bool Starter::start(const vpImage<vpRGBa> &I, TrackWindow *window, const TrackView &view)
{
  const StartOptions &start = m_options.start;
  if (!start.click.empty()) {
    return byClicks(I, window, view);
  }
  if (m_tag) {
    return byTag(I);
  }
  if (start.anywhere) {
    return anywhere(I);
  }
  if (!start.rough.empty()) {
    vpPoseDeviation deviation;
    deviation.rotation = vpMath::rad(start.roughAngle);
    deviation.translation = start.roughOffset;
    return about(I, readPose(start.rough), deviation);
  }
  if (!start.points.empty()) {
    const PointPairs points = readPoints(start.points);
    inGrayOrColor(I, m_options.gray,
                  [&](const auto &image) { m_tracker.initFromPoints(image, points.image, points.object); });
    return true;
  }
  const vpHomogeneousMatrix cMo = readPose(start.pose);
  inGrayOrColor(I, m_options.gray, [&](const auto &image) { m_tracker.initFromPose(image, cMo); });
  return true;
}

bool Starter::startAgain(const vpImage<vpRGBa> &I, TrackWindow *window, const TrackView &view)
{
  if (!m_options.start.click.empty() || m_options.start.anywhere || m_tag) {
    return start(I, window, view);
  }
  return about(I, m_tracker.getPose(), vpPoseDeviation());
}

} // namespace programs
