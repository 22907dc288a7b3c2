// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpKeyframes.h>

#include "keyframe/vpKeyframeFeatures.h"
#include "keyframe/vpKeyframeLooks.h"
#include "keyframe/vpPointPoses.h"
#include "point/vpSurfaceReader.h"

#include <visp3/se3/vpPoseExponential.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <deque>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t mostOfOne = 150;
// Of the features of a box around the object, many are beside it.
const int mostAround = 400;
const int mostSearched = 800;
const std::size_t fewest = 12; // Features of a keyframe that is worth looking for.
// Images until what passes in front of the object has left the places where it was.
const unsigned int ageToConfirm = 4;
// A view that differs by less from a keyframe adds little.
const double newDirection = 0.25; // Radians.
const double newDistance = 1.35;  // Ratio.
// Bits of 256. Descriptors of different corners differ by about 100.
const float mostDifference = 64.F;
const float mostAmbiguous = 0.9F; // Ratio to the second best.
const double reach = 4.;          // Pixels.
const double wideReach = 6.;      // The same for a pose that other cues had a part in.
const int border = 32;            // Around the object, for the corners at its edge.
// Of two poses, the nearer one is likelier where the other has no more than this many times its features.
const double clearlyMore = 1.3;

vpImageRegion regionOf(const vpRenderedView &view)
{
  const auto pixel = [&view](int place) { return static_cast<int>(std::floor(place / view.scale)); };
  const int left = pixel(view.left);
  const int top = pixel(view.top);
  return vpImageRegion(left - border, top - border, pixel(view.left + view.width) - left + 2 * border,
                       pixel(view.top + view.height) - top + 2 * border);
}
} // namespace

class vpKeyframes::Impl
{
public:
  struct Keyframe
  {
    Eigen::Vector3d direction; // Towards the camera, object frame, unit length.
    double distance = 0.;
    std::vector<Eigen::Vector3d> positions; // Object frame, metres.
    cv::Mat descriptors;                    // A row each.
    vpKeyframeLooks looks;                  // One each while it is proposed, else none.
    unsigned int age = 0;                   // Calls of confirm().

    bool isProposed() const { return looks.size() > 0; }
    bool isUsable() const { return !positions.empty() && !isProposed(); }
  };

  Keyframe viewAt(const vpHomogeneousMatrix &cMo) const
  {
    const Eigen::Vector3d camera = vpPoseExponential::toEigen(cMo).inverse().translation() - centre;
    Keyframe view;
    view.distance = camera.norm();
    view.direction = camera / view.distance;
    return view;
  }
  void add(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const vpRenderedView &depth, bool isProposed);
  static Keyframe confirmed(const Keyframe &keyframe, const vpCueFrame &frame, const vpPointCamera &camera);
  double mostMotion(const vpPointCamera &camera, const Where &where) const;
  void addMatches(const Keyframe &keyframe, const vpPointCamera &camera, double mostMotion);
  std::vector<vpPointMatch> bestOfEach() const;

  std::size_t mostKeyframes = 16;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double diameter = 1.;
  std::deque<Keyframe> keyframes; // The oldest first.
  vpKeyframeFeatures features;
  struct Candidate
  {
    int corner = 0; // Of the image.
    vpPointMatch match;
  };
  std::vector<Candidate> candidates;
  std::vector<vpPointMatch> matches; // Of the last search.
  double pixel = 0.;                 // Normalised coordinates.
};

bool vpKeyframes::isAvailable()
{
  return true;
}

vpKeyframes::vpKeyframes(std::size_t most) : m_impl(std::make_unique<Impl>())
{
  m_impl->mostKeyframes = std::max<std::size_t>(most, 1);
}

vpKeyframes::~vpKeyframes() = default;

void vpKeyframes::setObject(const Eigen::Vector3d &centre, double diameter)
{
  m_impl->centre = centre;
  m_impl->diameter = diameter;
  reset();
}

void vpKeyframes::reset()
{
  m_impl->keyframes.clear();
}

std::size_t vpKeyframes::size() const
{
  return m_impl->keyframes.size();
}

bool vpKeyframes::wants(const vpHomogeneousMatrix &cMo) const
{
  const Impl::Keyframe view = m_impl->viewAt(cMo);
  return std::none_of(m_impl->keyframes.begin(), m_impl->keyframes.end(), [&view](const Impl::Keyframe &known) {
    const double ratio = known.distance / view.distance;
    return known.direction.dot(view.direction) > std::cos(newDirection) && ratio < newDistance &&
           1. / ratio < newDistance;
  });
}

void vpKeyframes::learn(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const vpRenderedView &depth)
{
  m_impl->add(frame, cMo, depth, false);
}

void vpKeyframes::propose(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const vpRenderedView &depth)
{
  m_impl->add(frame, cMo, depth, true);
}

void vpKeyframes::Impl::add(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const vpRenderedView &depth,
                            bool isProposed)
{
  features.detect(frame, regionOf(depth), mostAround);
  const vpPointCamera camera(cMo, frame.camera());
  const vpSurfaceReader surface(depth);
  Keyframe keyframe = viewAt(cMo);
  for (std::size_t i = 0; i < features.corners().size() && keyframe.positions.size() < mostOfOne; ++i) {
    const cv::Point2f &at = features.corners()[i].pt;
    vpSurfaceElement element;
    if (surface.read(camera, Eigen::Vector2d(static_cast<double>(at.x), static_cast<double>(at.y)), element)) {
      keyframe.positions.push_back(element.position);
      keyframe.descriptors.push_back(features.descriptors().row(static_cast<int>(i)));
      if (isProposed) {
        keyframe.looks.add(frame, element, at);
      }
    }
  }
  if (keyframe.positions.size() < fewest) {
    // The view is known to show nothing.
    keyframe = viewAt(cMo);
  }
  if (keyframes.size() >= mostKeyframes) {
    keyframes.pop_front();
  }
  keyframes.push_back(std::move(keyframe));
}

void vpKeyframes::confirm(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo)
{
  const vpPointCamera camera(cMo, frame.camera());
  std::deque<Impl::Keyframe> &keyframes = m_impl->keyframes;
  for (auto keyframe = keyframes.begin(); keyframe != keyframes.end();) {
    if (keyframe->isProposed() && ++keyframe->age >= ageToConfirm) {
      *keyframe = Impl::confirmed(*keyframe, frame, camera);
      if (keyframe->positions.size() < fewest) {
        keyframe = keyframes.erase(keyframe);
        continue;
      }
    }
    ++keyframe;
  }
}

// With the features alone that are seen again.
vpKeyframes::Impl::Keyframe vpKeyframes::Impl::confirmed(const Keyframe &keyframe, const vpCueFrame &frame,
                                                         const vpPointCamera &camera)
{
  Keyframe result;
  result.direction = keyframe.direction;
  result.distance = keyframe.distance;
  for (std::size_t i = 0; i < keyframe.positions.size(); ++i) {
    if (keyframe.looks.isSeenAgain(i, frame, camera)) {
      result.positions.push_back(keyframe.positions[i]);
      result.descriptors.push_back(keyframe.descriptors.row(static_cast<int>(i)));
    }
  }
  return result;
}

// How far a feature may be from where the expected pose has it, normalised coordinates.
double vpKeyframes::Impl::mostMotion(const vpPointCamera &camera, const Where &where) const
{
  const double depth = camera.toCamera(centre).z();
  if (!(depth > 0.) || where.turn >= M_PI) {
    return HUGE_VAL;
  }
  return (where.shift + 0.5 * std::sin(std::min(where.turn, M_PI / 2.))) * diameter / depth;
}

// Corners of the image that look like those of the keyframe.
void vpKeyframes::Impl::addMatches(const Keyframe &keyframe, const vpPointCamera &camera, double mostMotion)
{
  if (!keyframe.isUsable() || features.corners().size() < fewest) {
    return;
  }
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_HAMMING).knnMatch(keyframe.descriptors, features.descriptors(), nearest, 2);
  for (const std::vector<cv::DMatch> &pair : nearest) {
    if (pair.size() < 2 || pair[0].distance > mostDifference || pair[0].distance > mostAmbiguous * pair[1].distance) {
      continue;
    }
    const cv::Point2f &at = features.corners()[static_cast<std::size_t>(pair[0].trainIdx)].pt;
    Candidate candidate;
    candidate.corner = pair[0].trainIdx;
    candidate.match.position = keyframe.positions[static_cast<std::size_t>(pair[0].queryIdx)];
    candidate.match.place = camera.normalized({static_cast<double>(at.x), static_cast<double>(at.y)});
    candidate.match.doubt = static_cast<double>(pair[0].distance / std::max(pair[1].distance, 1.F));
    const Eigen::Vector3d seen = camera.toCamera(candidate.match.position);
    if (seen.z() > 0. && !((seen.head<2>() / seen.z() - candidate.match.place).norm() < mostMotion)) {
      continue;
    }
    candidates.push_back(candidate);
  }
}

// A corner of the image is one place on the object: that of the least doubt.
std::vector<vpPointMatch> vpKeyframes::Impl::bestOfEach() const
{
  std::vector<const Candidate *> best(features.corners().size(), nullptr);
  for (const Candidate &candidate : candidates) {
    const Candidate *&known = best[static_cast<std::size_t>(candidate.corner)];
    if (known == nullptr || candidate.match.doubt < known->match.doubt) {
      known = &candidate;
    }
  }
  std::vector<vpPointMatch> chosen;
  for (const Candidate *candidate : best) {
    if (candidate != nullptr) {
      chosen.push_back(candidate->match);
    }
  }
  return chosen;
}

std::vector<vpKeyframePose> vpKeyframes::find(const vpCueFrame &frame, const vpImageRegion &region, const Where &where)
{
  Impl &impl = *m_impl;
  const bool isAnyUsable = std::any_of(impl.keyframes.begin(), impl.keyframes.end(),
                                       [](const Impl::Keyframe &keyframe) { return keyframe.isUsable(); });
  if (!isAnyUsable) {
    return {};
  }
  impl.features.detect(frame, region, mostSearched);
  const vpPointCamera camera(where.expected, frame.camera());
  const double mostMotion = impl.mostMotion(camera, where);
  impl.candidates.clear();
  for (const Impl::Keyframe &keyframe : impl.keyframes) {
    impl.addMatches(keyframe, camera, mostMotion);
  }
  impl.matches = impl.bestOfEach();
  impl.pixel = 1. / frame.camera().get_px();
  vpPointPoses poses(impl.matches, reach * impl.pixel);
  poses.draw(impl.centre, impl.diameter, where);
  std::vector<vpKeyframePose> found = poses.poses();
  if (found.size() == 2 && found[0].agreeing < clearlyMore * found[1].agreeing) {
    const auto turn = [&where](const vpKeyframePose &pose) {
      return Eigen::AngleAxisd(vpPoseExponential::toEigen(where.expected.inverse() * pose.cMo).linear()).angle();
    };
    if (turn(found[1]) < turn(found[0])) {
      std::swap(found[0], found[1]);
    }
  }
  return found;
}

unsigned int vpKeyframes::agreeing(const vpHomogeneousMatrix &cMo) const
{
  return vpPointPoses::agreeing(m_impl->matches, vpPoseExponential::toEigen(cMo), wideReach * m_impl->pixel);
}

END_VISP_NAMESPACE
