// SPDX-License-Identifier: GPL-2.0-or-later
#include "keyframe/vpPointPoses.h"

#include <visp3/se3/vpPoseExponential.h>
#include <visp3/se3/vpPoseRandom.h>

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const unsigned int mostDraws = 300;
const double confidence = 0.995;
// Poses that differ by less than this are the same one, seen a little better.
const double sameTurn = 0.25;  // Radians.
const double sameShift = 0.15; // Diameters.
const std::size_t mostPoses = 2;
const unsigned int fewest = 10; // Wrong matches agree by chance up to there.
const unsigned int refinements = 8;

// Draws that find three right matches nearly surely, for that share of right ones.
unsigned int drawsFor(double share)
{
  const double all = share * share * share;
  if (!(all > 0.)) {
    return mostDraws;
  }
  if (all >= confidence) {
    return 1;
  }
  return static_cast<unsigned int>(
      std::min(std::ceil(std::log1p(-confidence) / std::log1p(-all)), static_cast<double>(mostDraws)));
}

Eigen::Isometry3d poseOf(const cv::Mat &rotation, const cv::Mat &translation)
{
  const Eigen::Vector3d turn(rotation.at<double>(0), rotation.at<double>(1), rotation.at<double>(2));
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (turn.norm() > 0.) {
    pose.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }
  pose.translation() = Eigen::Vector3d(translation.at<double>(0), translation.at<double>(1), translation.at<double>(2));
  return pose;
}
} // namespace

vpPointPoses::vpPointPoses(std::vector<vpPointMatch> matches, double reach)
    : m_matches(std::move(matches)), m_reach(reach)
{
  std::stable_sort(m_matches.begin(), m_matches.end(),
                   [](const vpPointMatch &a, const vpPointMatch &b) { return a.doubt < b.doubt; });
}

unsigned int vpPointPoses::agreeing(const std::vector<vpPointMatch> &matches, const Eigen::Isometry3d &pose,
                                    double reach)
{
  return static_cast<unsigned int>(std::count_if(matches.begin(), matches.end(), [&](const vpPointMatch &match) {
    const Eigen::Vector3d seen = pose * match.position;
    return seen.z() > 0. && (seen.head<2>() / seen.z() - match.place).norm() < reach;
  }));
}

vpPointPoses::Vote vpPointPoses::vote(const Eigen::Isometry3d &pose) const
{
  Vote result;
  const double limit = m_reach * m_reach;
  for (const vpPointMatch &match : m_matches) {
    const Eigen::Vector3d seen = pose * match.position;
    if (!(seen.z() > 0.)) {
      continue;
    }
    const double error = (seen.head<2>() / seen.z() - match.place).squaredNorm();
    if (error < limit) {
      result.value += 1. - error / limit;
      ++result.agreeing;
    }
  }
  return result;
}

bool vpPointPoses::isAllowed(const Eigen::Isometry3d &pose) const
{
  const Eigen::Vector3d at = pose * m_centre;
  if (!pose.matrix().allFinite() || !(at.z() > 0.) || (at - m_expected * m_centre).norm() > m_shift) {
    return false;
  }
  const Eigen::Matrix3d turn = m_expected.linear().transpose() * pose.linear();
  return Eigen::AngleAxisd(turn).angle() <= m_turn + 1e-6;
}

void vpPointPoses::consider(const Eigen::Isometry3d &pose)
{
  if (!isAllowed(pose)) {
    return;
  }
  const Drawn drawn = {pose, vote(pose)};
  const auto isSame = [&](const Drawn &other) {
    const Eigen::Matrix3d turn = other.pose.linear().transpose() * pose.linear();
    return Eigen::AngleAxisd(turn).angle() < sameTurn &&
           (other.pose * m_centre - pose * m_centre).norm() < sameShift * m_diameter;
  };
  const auto same = std::find_if(m_best.begin(), m_best.end(), isSame);
  if (same != m_best.end()) {
    if (drawn.vote.value > same->vote.value) {
      *same = drawn;
    }
  } else if (m_best.size() < mostPoses) {
    m_best.push_back(drawn);
  } else if (drawn.vote.value > m_best.back().vote.value) {
    m_best.back() = drawn;
  }
  std::stable_sort(m_best.begin(), m_best.end(),
                   [](const Drawn &a, const Drawn &b) { return a.vote.value > b.vote.value; });
}

void vpPointPoses::draw(const Eigen::Vector3d &centre, double diameter, const vpKeyframes::Where &where)
{
  m_centre = centre;
  m_diameter = diameter;
  m_expected = vpPoseExponential::toEigen(where.expected);
  m_shift = where.shift * diameter;
  m_turn = where.turn;
  m_best.clear();
  m_poses.clear();
  const std::size_t count = m_matches.size();
  if (count < fewest) {
    return;
  }
  const cv::Mat camera = cv::Mat::eye(3, 3, CV_64F);
  vpPoseRandom random(count);
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  const auto pick = [&random, count] {
    const double u = random.uniform();
    return static_cast<std::size_t>(u * u * static_cast<double>(count));
  };
  for (unsigned int i = 0, needed = mostDraws; i < needed; ++i) {
    const std::size_t drawn[3] = {pick(), pick(), pick()};
    if (drawn[0] == drawn[1] || drawn[1] == drawn[2] || drawn[0] == drawn[2]) {
      continue;
    }
    cv::Mat_<double> object(3, 3);
    cv::Mat_<double> image(3, 2);
    for (int k = 0; k < 3; ++k) {
      const vpPointMatch &match = m_matches[drawn[k]];
      for (int c = 0; c < 3; ++c) {
        object(k, c) = match.position[c];
      }
      image(k, 0) = match.place.x();
      image(k, 1) = match.place.y();
    }
    const int solutions =
        cv::solveP3P(object, image, camera, cv::noArray(), rotations, translations, cv::SOLVEPNP_AP3P);
    for (int k = 0; k < solutions; ++k) {
      consider(poseOf(rotations[static_cast<std::size_t>(k)], translations[static_cast<std::size_t>(k)]));
    }
    if (!m_best.empty()) {
      needed = std::min(needed, drawsFor(m_best.front().vote.agreeing / static_cast<double>(count)));
    }
  }
  for (const Drawn &best : m_best) {
    const Eigen::Isometry3d pose = refined(best.pose);
    const unsigned int agreeing = vote(pose).agreeing;
    if (agreeing >= fewest) {
      m_poses.push_back({vpPoseExponential::fromEigen(pose), agreeing, static_cast<unsigned int>(count)});
    }
  }
}

// Gauss and Newton with the matches that agree, each less the farther it is off.
Eigen::Isometry3d vpPointPoses::refined(const Eigen::Isometry3d &start) const
{
  Eigen::Isometry3d pose = start;
  const double limit = m_reach * m_reach;
  for (unsigned int i = 0; i < refinements; ++i) {
    vpPoseMatrix6 A = vpPoseMatrix6::Zero();
    vpPoseTangent b = vpPoseTangent::Zero();
    for (const vpPointMatch &match : m_matches) {
      const Eigen::Vector3d seen = pose * match.position;
      if (!(seen.z() > 0.)) {
        continue;
      }
      const Eigen::Vector2d at = seen.head<2>() / seen.z();
      const Eigen::Vector2d error = at - match.place;
      const double share = error.squaredNorm() / limit;
      if (share >= 1.) {
        continue;
      }
      Eigen::Matrix<double, 2, 3> projection;
      projection << 1., 0., -at.x(), 0., 1., -at.y();
      projection /= seen.z();
      Eigen::Matrix<double, 3, 6> motion; // Of the place in the camera's frame, by a motion of the object in its own.
      motion.leftCols<3>() = pose.linear();
      Eigen::Matrix3d cross;
      cross << 0., -match.position.z(), match.position.y(), match.position.z(), 0., -match.position.x(),
          -match.position.y(), match.position.x(), 0.;
      motion.rightCols<3>() = -pose.linear() * cross;
      const Eigen::Matrix<double, 2, 6> jacobian = projection * motion;
      const double weight = (1. - share) * (1. - share);
      A += weight * jacobian.transpose() * jacobian;
      b += weight * jacobian.transpose() * error;
    }
    const vpPoseTangent step = -A.ldlt().solve(b);
    if (!step.allFinite()) {
      return start;
    }
    pose = pose * vpPoseExponential::expEigen(step);
  }
  return vote(pose).value >= vote(start).value ? pose : start;
}

END_VISP_NAMESPACE
