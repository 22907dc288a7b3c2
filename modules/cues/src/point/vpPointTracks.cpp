// SPDX-License-Identifier: GPL-2.0-or-later
#include "point/vpPointTracks.h"

#include "point/vpFaceBorder.h"
#include "point/vpPointArea.h"

#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// A patch that was followed from the last frame is there; one that was expected by the pose alone is near, and has to
// be like itself to be believed.
const vpSurfacePatch::Limits followed = {2.F, 0.8F};
const vpSurfacePatch::Limits expected = {3.F, 0.9F};
const double patchRoom = vpSurfacePatch::half + 2.;
// Occluders pass, images are blurred: a point is looked for in so many trusted frames more.
const int mostMisses = 3;
const double refreshShare = 0.75;
const int refreshAge = 10; // Trusted frames.
// Frames in which a new point has to agree with the pose before it takes part in it.
const int trialFrames = 2;
// Masks are looked at once for each block when new points are chosen; a found point is always checked by itself.
const int maskBlock = 4; // Pixels.
} // namespace

void vpPointTracks::forget()
{
  m_tracks.clear();
  m_nextId = 0;
  std::fill(m_trackOf.begin(), m_trackOf.end(), -1);
  m_reference.clear();
  m_found = 0;
  m_fullCount = static_cast<std::size_t>(m_settings.maxFeatures);
  m_age = 0;
  m_hasStarted = false;
}

bool vpPointTracks::lacksPoints() const
{
  const double full = static_cast<double>(std::min(m_fullCount, static_cast<std::size_t>(m_settings.maxFeatures)));
  return static_cast<double>(m_found) < refreshShare * full ||
         (m_age >= refreshAge && m_found < static_cast<std::size_t>(m_settings.maxFeatures));
}

bool vpPointTracks::prepareImage(const vpCueFrame &frame, const vpModelView &view)
{
  const cv::Size size(static_cast<int>(frame.width()), static_cast<int>(frame.height()));
  if (size != m_imageSize || frame.camera() != m_camera) {
    forget();
    m_imageSize = size;
    m_camera = frame.camera();
    m_currentNumber = 0;
  }
  const cv::Rect needed = vpPointArea::expected(view, vpPointCamera(view.pose(), m_camera), size);
  if (needed.area() == 0) {
    m_currentNumber = 0;
    return false;
  }
  if (frame.number() == m_currentNumber && (needed & m_current.area()) == needed) {
    return true;
  }
  const cv::Rect before = m_reference.isEmpty() ? cv::Rect() : m_reference.area();
  const cv::Size wanted = vpPointArea::size(needed, before, size);
  if (!m_reference.isEmpty() && wanted != before.size()) {
    m_reference.move(vpPointArea::placed(wanted, before, size), m_settings.windowSize, m_settings.pyramidLevels);
  }
  m_current.build(frame.gray(), vpPointArea::placed(wanted, needed, size), m_settings.windowSize,
                  m_settings.pyramidLevels);
  m_currentNumber = frame.number();
  return true;
}

void vpPointTracks::expectTracks(const vpCueFrame &frame, const vpModelView &view,
                                 std::vector<vpPointCue::Match> &matches)
{
  const vpPointCamera camera(view.pose(), m_camera);
  m_flow.clear();
  for (std::size_t i = 0; i < m_tracks.size(); ++i) {
    const Track &track = m_tracks[i];
    const Eigen::Vector3d cX = camera.toCamera(track.surface.position);
    if (!(cX.z() > 0.) || !track.surface.isFacing(camera, cX)) {
      continue;
    }
    const Eigen::Vector2d pixel = camera.project(cX);
    if (!m_current.contains(pixel, 0.) || frame.isMasked(pixel.x(), pixel.y()) ||
        (view.depth() != nullptr && vpSurfaceReader(*view.depth()).hides(pixel, cX.z()))) {
      continue;
    }
    matches.push_back({track.surface.position, pixel, false, track.trial == 0, track.id});
    m_trackOf.push_back(static_cast<int>(i));
    const bool isFollowed = track.misses == 0;
    m_flowOf.push_back(isFollowed ? static_cast<std::ptrdiff_t>(m_flow.size()) : -1);
    if (isFollowed) {
      m_flow.add(m_reference.inArea(track.pixel), m_current.inArea(pixel));
    }
  }
}

void vpPointTracks::findTracks(const vpCueFrame &frame, const vpPointCamera &camera,
                               std::vector<vpPointCue::Match> &matches)
{
  m_flow.run(m_reference, m_current, m_settings);
  const cv::Point2f correction = m_flow.medianCorrection();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    // KLT knows nothing of turned or scaled windows: where it fails, the patch may still be where it is expected.
    const std::size_t flow = static_cast<std::size_t>(std::max<std::ptrdiff_t>(m_flowOf[i], 0));
    const bool isFollowed = m_flowOf[i] >= 0 && m_flow.isFound(flow);
    cv::Point2f place = isFollowed ? m_flow.place(flow) : m_current.inArea(matches[i].pixel) + correction;
    const Track &track = m_tracks[static_cast<std::size_t>(m_trackOf[i])];
    Eigen::Matrix2d distortion;
    const vpSurfacePatch &patch = lookFor(track, camera, distortion).patch;
    if (!patch.align(m_current.pixels(), distortion, isFollowed ? followed : expected, place)) {
      continue;
    }
    const Eigen::Vector2d pixel = m_current.inImage(place);
    if (!frame.isMasked(pixel.x(), pixel.y())) {
      matches[i].pixel = pixel;
      matches[i].found = true;
      ++m_found;
    }
  }
}

void vpPointTracks::match(const vpCueFrame &frame, const vpModelView &view, std::vector<vpPointCue::Match> &matches)
{
  matches.clear();
  m_trackOf.clear();
  m_flowOf.clear();
  m_found = 0;
  m_wantsPoints = false;
  if (!prepareImage(frame, view)) {
    return;
  }
  if (!m_tracks.empty() && !m_reference.isEmpty()) {
    expectTracks(frame, view, matches);
    findTracks(frame, vpPointCamera(view.pose(), m_camera), matches);
  }
  m_wantsPoints = lacksPoints();
  if (m_wantsPoints) {
    keepMask(frame);
  }
}

void vpPointTracks::keepMask(const vpCueFrame &frame)
{
  const cv::Rect &area = m_current.area();
  m_masked.create((area.height - 1) / maskBlock + 1, (area.width - 1) / maskBlock + 1, CV_8U);
  for (int i = 0; i < m_masked.rows; ++i) {
    for (int j = 0; j < m_masked.cols; ++j) {
      m_masked.at<unsigned char>(i, j) = frame.isMasked(area.x + maskBlock * j, area.y + maskBlock * i) ? 255 : 0;
    }
  }
}

void vpPointTracks::learn(const vpHomogeneousMatrix &cMo, const std::vector<vpPointCue::Match> &matches,
                          const std::vector<char> &trusted, const vpPointCue::DepthSource &depth)
{
  if (m_currentNumber == 0) {
    return;
  }
  m_currentNumber = 0;
  std::swap(m_reference, m_current);
  const vpPointCamera camera(cMo, m_camera);
  for (Track &track : m_tracks) {
    ++track.misses;
    track.pixel = camera.project(camera.toCamera(track.surface.position));
  }
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (trusted[i] != 0 && m_trackOf[i] >= 0) {
      Track &track = m_tracks[static_cast<std::size_t>(m_trackOf[i])];
      track.misses = 0;
      track.trial = std::max(track.trial - 1, 0);
      track.pixel = matches[i].pixel;
    }
  }
  const auto lost = [&](const Track &track) { return isLost(track, camera); };
  m_tracks.erase(std::remove_if(m_tracks.begin(), m_tracks.end(), lost), m_tracks.end());
  for (Track &track : m_tracks) {
    if (track.misses == 0) {
      renew(track, camera);
    }
  }
  std::fill(m_trackOf.begin(), m_trackOf.end(), -1);
  ++m_age;
  if (m_wantsPoints && depth) {
    const vpRenderedView *rendered = depth(cMo);
    if (rendered != nullptr) {
      addTracks(camera, *rendered);
    }
  }
  m_wantsPoints = false;
}

const vpPointTracks::Look &vpPointTracks::lookFor(const Track &track, const vpPointCamera &camera,
                                                  Eigen::Matrix2d &distortion) const
{
  const Eigen::Matrix<double, 2, 3> derivative =
      camera.derivative(camera.toCamera(track.surface.position)) * camera.cRo;
  distortion = derivative * track.first.across;
  if (!track.hasLater || vpSurfacePatch::isSimilar(distortion)) {
    return track.first;
  }
  distortion = derivative * track.later.across;
  return track.later;
}

void vpPointTracks::renew(Track &track, const vpPointCamera &camera)
{
  Eigen::Matrix2d distortion;
  const Look &look = lookFor(track, camera, distortion);
  if (vpSurfacePatch::isSimilar(distortion) || !(std::fabs(distortion.determinant()) > 1e-6)) {
    return;
  }
  // Seen from too far elsewhere: the place where it was found is kept, and shown as it looks now.
  track.later.across = (look.across * distortion.inverse()).eval();
  track.later.patch.take(m_reference.pixels(), m_reference.inArea(track.pixel));
  track.hasLater = true;
}

bool vpPointTracks::isLost(const Track &track, const vpPointCamera &camera) const
{
  const Eigen::Vector3d cX = camera.toCamera(track.surface.position);
  const int allowed = track.trial > 0 ? 0 : mostMisses; // A new point that disagrees once is no point of the object.
  return track.misses > allowed || !(cX.z() > 0.) || !track.surface.isFacing(camera, cX) ||
         !m_reference.contains(track.pixel, patchRoom);
}

void vpPointTracks::markAllowed(const vpSurfaceReader &reader, cv::Mat &mask) const
{
  reader.markSmooth(m_reference.area(), mask);
  for (int i = 0; i < m_masked.rows; ++i) {
    for (int j = 0; j < m_masked.cols; ++j) {
      if (m_masked.at<unsigned char>(i, j) != 0) {
        const cv::Rect block(maskBlock * j - maskBlock / 2, maskBlock * i - maskBlock / 2, maskBlock, maskBlock);
        mask(block & cv::Rect(cv::Point(), mask.size())).setTo(0);
      }
    }
  }
  vpFaceBorder::takeOff(mask, static_cast<int>(m_settings.maskBorder));
}

void vpPointTracks::addTracks(const vpPointCamera &camera, const vpRenderedView &rendered)
{
  const vpSurfaceReader reader(rendered);
  const bool isStart = !m_hasStarted; // The user's pose vouches for those points.
  m_hasStarted = true;
  const auto isHidden = [&](const Track &track) {
    return reader.hides(camera.project(camera.toCamera(track.surface.position)),
                        camera.toCamera(track.surface.position).z());
  };
  m_tracks.erase(std::remove_if(m_tracks.begin(), m_tracks.end(), isHidden), m_tracks.end());
  m_taken.clear();
  for (const Track &track : m_tracks) {
    m_taken.push_back(m_reference.inArea(track.pixel));
  }
  markAllowed(reader, m_allowed);
  m_finder.find(m_reference.pixels(), m_allowed, m_taken, m_settings, m_corners);
  for (const cv::Point2f &corner : m_corners) {
    Track track;
    track.pixel = m_reference.inImage(corner);
    if (m_reference.contains(track.pixel, patchRoom) && reader.read(camera, track.pixel, track.surface) &&
        track.surface.isFacing(camera, camera.toCamera(track.surface.position)) &&
        (!m_filter || m_filter(track.surface.position))) {
      track.id = m_nextId++;
      track.first.across = track.surface.across;
      track.first.patch.take(m_reference.pixels(), corner);
      track.trial = isStart ? 0 : trialFrames;
      m_tracks.push_back(track);
    }
  }
  m_fullCount = m_tracks.size();
  m_age = 0;
}

END_VISP_NAMESPACE
