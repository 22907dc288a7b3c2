// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpPoseSearch.h"

#include "search/vpSameSide.h"

#include <visp3/se3/vpPoseRandom.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>

BEGIN_VISP_NAMESPACE

namespace {
// Of a score, at one spread. Right poses have 0.06 to 0.2 more than the best wrong ones, mostly.
const double lightPrior = 0.02;
const double heavyPrior = 0.04;
} // namespace

vpPoseSearch::vpPoseSearch(const vpPoseScore &score, const vpTrackedModel &model, std::uint64_t seed)
    : vpPoseSearch([&score](const vpHomogeneousMatrix &cMo) { return score(cMo).total; }, model, seed)
{
}

vpPoseSearch::vpPoseSearch(const Score &score, const vpTrackedModel &model, std::uint64_t seed)
    : m_score(score), m_centre(model.centre()), m_diameter(model.diameter()), m_seed(seed)
{
}

void vpPoseSearch::setPrior(const std::vector<vpHomogeneousMatrix> &poses, const Spread &spread, Tail tail)
{
  m_priorPoses = poses;
  m_priorSpread = spread;
  m_priorTail = tail;
}

vpHomogeneousMatrix vpPoseSearch::draw(const vpHomogeneousMatrix &cMo, const Spread &spread)
{
  vpPoseRandom random(m_seed, {m_draws++});
  const vpPoseTangent noise = random.normalTangent();
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
  const Eigen::Vector3d at = pose * m_centre;
  const Eigen::Vector3d sight = at.normalized();
  Eigen::Vector3d shift = spread.translation * m_diameter * noise.head<3>();
  shift += (spread.depth * m_diameter * noise[2] - shift.dot(sight)) * sight;
  const Eigen::Vector3d turned = spread.rotation * noise.tail<3>();
  const double angle = turned.norm();
  const Eigen::Matrix3d rotation =
      pose.linear() *
      (angle > 0. ? Eigen::AngleAxisd(angle, turned / angle).toRotationMatrix() : Eigen::Matrix3d::Identity());
  Eigen::Isometry3d drawn = Eigen::Isometry3d::Identity();
  drawn.linear() = rotation;
  drawn.translation() = at + shift - rotation * m_centre;
  return vpPoseExponential::fromEigen(drawn);
}

// In deviations; large for poses that are apart. An image tells distances from the camera least, so they have a unit of
// their own.
double vpPoseSearch::distance(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b, const Spread &unit) const
{
  const Eigen::Isometry3d first =
      vpPoseExponential::toEigen(m_symmetries == nullptr ? a : m_symmetries->nearest(a, b, m_centre, 0.5 * m_diameter));
  const Eigen::Isometry3d second = vpPoseExponential::toEigen(b);
  const Eigen::Vector3d from = first * m_centre;
  const Eigen::Vector3d to = second * m_centre;
  const Eigen::Vector3d sight = (from + to).normalized();
  const double along = sight.dot(to - from);
  const double shift = ((to - from) - along * sight).norm() / (m_diameter * unit.translation);
  const double depth = along / (m_diameter * unit.depth);
  const double cosine = 0.5 * ((first.linear().transpose() * second.linear()).trace() - 1.);
  const double angle = std::acos(std::min(std::max(cosine, -1.), 1.)) / unit.rotation;
  return std::sqrt(shift * shift + depth * depth + angle * angle);
}

double vpPoseSearch::scoreOf(const vpHomogeneousMatrix &cMo)
{
  ++m_scored;
  const double score = m_score(cMo);
  if (m_priorPoses.empty()) {
    return score;
  }
  double d = HUGE_VAL;
  for (const vpHomogeneousMatrix &pose : m_priorPoses) {
    d = std::min(d, distance(cMo, pose, m_priorSpread));
  }
  return score - (m_priorTail == Tail::HEAVY ? heavyPrior * std::log1p(d * d) : lightPrior * d * d);
}

void vpPoseSearch::alignByColors(const vpContourAligner &aligner, double reach, unsigned int steps, std::size_t every)
{
  align(steps, [&aligner, reach, every](Eigen::Isometry3d &pose) { return aligner.stepByColors(pose, reach, every); });
}

void vpPoseSearch::alignByEdges(const vpContourAligner &aligner, unsigned int steps)
{
  align(steps, [&aligner](Eigen::Isometry3d &pose) { return aligner.stepByEdges(pose); });
}

template <typename Step> void vpPoseSearch::align(unsigned int steps, Step &&step)
{
  for (vpPoseCandidate &candidate : m_candidates) {
    if (isOver()) {
      return;
    }
    Eigen::Isometry3d pose = vpPoseExponential::toEigen(candidate.cMo);
    for (unsigned int i = 0; i < steps && step(pose); ++i) {
    }
    if (pose.matrix().allFinite()) {
      candidate.cMo = vpPoseExponential::fromEigen(pose);
    }
  }
}

bool vpPoseSearch::isOver()
{
  m_isCutShort = m_isCutShort || m_limit.isOver();
  return m_isCutShort;
}

void vpPoseSearch::mix()
{
  if (m_limit.isLimited()) {
    std::shuffle(m_candidates.begin(), m_candidates.end(), std::mt19937_64(m_seed));
  }
}

void vpPoseSearch::addCopies()
{
  m_candidates.insert(m_candidates.end(), m_copies.begin(), m_copies.end());
  m_copies.clear();
}

void vpPoseSearch::score(std::size_t first)
{
  for (std::size_t i = first; i < m_candidates.size() && !isOver(); ++i) {
    m_candidates[i].score = scoreOf(m_candidates[i].cMo);
  }
}

void vpPoseSearch::scatterAround(const Eigen::Vector3d &centre, const vpHomogeneousMatrix &cMo, const Spread &spread,
                                 std::size_t number)
{
  const Eigen::Isometry3d moved = vpSameSide(vpPoseExponential::toEigen(cMo), m_centre, centre);
  scatter({vpPoseExponential::fromEigen(moved)}, spread, number);
}

void vpPoseSearch::scatter(const std::vector<vpHomogeneousMatrix> &starts, const Spread &spread, std::size_t number)
{
  for (const vpHomogeneousMatrix &start : starts) {
    m_candidates.push_back({start});
  }
  for (std::size_t i = 0; i < number && !starts.empty(); ++i) {
    m_candidates.push_back({draw(starts[i % starts.size()], spread)});
  }
}

void vpPoseSearch::scatter(const std::vector<vpWeightedPose> &starts, const Spread &spread, std::size_t number)
{
  double total = 0.;
  for (const vpWeightedPose &start : starts) {
    total += start.weight;
  }
  for (const vpWeightedPose &start : starts) {
    scatter(std::vector<vpHomogeneousMatrix>{start.cMo}, spread,
            static_cast<std::size_t>(start.weight / total * static_cast<double>(number)));
  }
}

void vpPoseSearch::keepBest(std::size_t keep, const Spread &apart)
{
  std::stable_sort(m_candidates.begin(), m_candidates.end(),
                   [](const vpPoseCandidate &a, const vpPoseCandidate &b) { return a.score > b.score; });
  std::vector<vpPoseCandidate> kept;
  for (const vpPoseCandidate &candidate : m_candidates) {
    if (kept.size() == keep || !(candidate.score > -HUGE_VAL)) {
      break;
    }
    const bool isNew = std::none_of(kept.begin(), kept.end(), [&](const vpPoseCandidate &other) {
      return distance(candidate.cMo, other.cMo, apart) < 1.;
    });
    if (isNew) {
      kept.push_back(candidate);
    }
  }
  m_candidates = std::move(kept);
}

std::size_t vpPoseSearch::breed(const Spread &spread, std::size_t keep, std::size_t number)
{
  keepBest(keep, spread);
  const std::size_t parents = m_candidates.size();
  for (std::size_t i = 0; i < number && parents > 0; ++i) {
    m_candidates.push_back({draw(m_candidates[i % parents].cMo, spread.halved())});
  }
  return parents;
}

void vpPoseSearch::anneal(Spread spread, std::size_t keep, std::size_t number, unsigned int layers)
{
  for (unsigned int layer = 0; layer < layers; ++layer) {
    score(breed(spread, keep, number));
    spread = spread.halved();
  }
  keepBest(keep, spread);
}

END_VISP_NAMESPACE
