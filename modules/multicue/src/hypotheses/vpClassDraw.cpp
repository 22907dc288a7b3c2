// SPDX-License-Identifier: GPL-2.0-or-later
#include "hypotheses/vpClassDraw.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// How well edges agree with a motion where all is well: the noise of their means and what the first order leaves out.
const double agreementNoise = 1.; // Pixels.
// A class that is farther than this many standard deviations from what is expected tells nothing about the motion.
const double gate = 3.;
// A straight edge tells two things about the motion, however many control points it has.
const double measurements = 2.;
// After this many contours the motion is known, if it can be, and the classes of the others follow from it.
const std::size_t decisive = 5;
// Draws that lead to no new motion, one after the other, before the search ends.
const unsigned int patience = 6;

// tr(A P) of symmetric matrices.
double trace(const vpPoseMatrix6 &A, const vpPoseMatrix6 &P)
{
  return A.cwiseProduct(P).sum();
}

// Gauss and Jordan's elimination, which needs no pivots for a covariance. Eigen's solvers take blocked products for
// matrices of this size, ten times as long.
void invert(vpPoseMatrix6 &M)
{
  for (int k = 0; k < 6; ++k) {
    const double pivot = 1. / M(k, k);
    M(k, k) = 1.;
    M.col(k) *= pivot;
    for (int j = 0; j < 6; ++j) {
      if (j != k) {
        const double factor = M(k, j);
        M(k, j) = 0.;
        M.col(j) -= factor * M.col(k);
      }
    }
  }
}
} // namespace

void vpClassDraw::compute(const vpContourClasses &classes, double prior, double tolerance, unsigned int count,
                          std::uint64_t seed, std::uint64_t stream)
{
  m_prior = prior;
  m_size = 0;
  const unsigned int most = classes.most() > 1 ? count : 1;
  unsigned int old = 0;
  for (unsigned int i = 0; i < most && old < patience; ++i) {
    if (m_draws.size() == m_size) {
      m_draws.emplace_back();
    }
    Draw &draw = m_draws[m_size];
    vpPoseRandom random(seed, {stream, i});
    drawOnce(classes, random, draw);
    conclude(classes, draw);
    const auto end = m_draws.begin() + static_cast<std::ptrdiff_t>(m_size);
    const auto same = std::find_if(m_draws.begin(), end, [&](const Draw &other) {
      return classes.difference(other.motion, draw.motion) < tolerance;
    });
    if (same == end) {
      old = 0;
      ++m_size;
      continue;
    }
    ++old;
    if (draw.error < same->error) {
      std::swap(*same, draw);
    }
  }
}

// A contour that is still open, long ones more likely.
std::size_t vpClassDraw::pick(const vpContourClasses &classes, vpPoseRandom &random)
{
  double left = random.uniform() * m_openPoints;
  std::size_t last = 0;
  for (std::size_t i = 0; i < m_open.size(); ++i) {
    if (m_open[i] != 0) {
      last = i;
      left -= classes.contours()[i].count;
      if (left < 0.) {
        break;
      }
    }
  }
  m_open[last] = 0;
  m_openPoints -= classes.contours()[last].count;
  return last;
}

// The chances of a contour's classes; they add up to the value returned.
double vpClassDraw::findChances(const vpContourClasses &classes, const vpContourClasses::Contour &contour,
                                Chances &chance) const
{
  double best = HUGE_VAL;
  for (int label = 0; label < contour.classes; ++label) {
    const vpContourClasses::Class &c = classes.at(contour, label);
    const double variance = agreementNoise * agreementNoise + trace(c.A, m_covariance) / c.size;
    const double distance = 0.5 * c.error(m_motion) / variance;
    chance[static_cast<std::size_t>(label)] = distance;
    best = std::min(best, distance);
  }
  double sum = 0.;
  for (int label = 0; label < contour.classes; ++label) {
    double &c = chance[static_cast<std::size_t>(label)];
    c = classes.at(contour, label).weight * std::exp(best - c);
    sum += c;
  }
  return sum;
}

int vpClassDraw::drawClass(const vpContourClasses &classes, const vpContourClasses::Contour &contour,
                           vpPoseRandom &random) const
{
  if (contour.classes == 1) {
    return 0;
  }
  Chances chance{};
  double left = random.uniform() * findChances(classes, contour, chance);
  for (int label = 0; label < contour.classes; ++label) {
    left -= chance[static_cast<std::size_t>(label)];
    if (left < 0.) {
      return label;
    }
  }
  return contour.classes - 1;
}

int vpClassDraw::likeliestClass(const vpContourClasses &classes, const vpContourClasses::Contour &contour) const
{
  if (contour.classes == 1) {
    return 0;
  }
  Chances chance{};
  findChances(classes, contour, chance);
  return static_cast<int>(std::max_element(chance.begin(), chance.begin() + contour.classes) - chance.begin());
}

void vpClassDraw::believe(const vpContourClasses::Class &chosen)
{
  const double variance = agreementNoise * agreementNoise + trace(chosen.A, m_covariance) / chosen.size;
  if (chosen.error(m_motion) < gate * gate * variance) {
    const double weight = measurements / (chosen.size * agreementNoise * agreementNoise);
    m_information += weight * chosen.A;
    m_gradient += weight * chosen.b;
  }
}

void vpClassDraw::estimate()
{
  m_covariance = m_information;
  invert(m_covariance);
  m_motion = -m_covariance * m_gradient;
}

void vpClassDraw::drawOnce(const vpContourClasses &classes, vpPoseRandom &random, Draw &draw)
{
  const std::vector<vpContourClasses::Contour> &contours = classes.contours();
  draw.classes.assign(contours.size(), -1);
  m_open.assign(contours.size(), 0);
  m_openPoints = 0.;
  std::size_t left = 0;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (contours[i].classes > 0) {
      m_open[i] = 1;
      m_openPoints += contours[i].count;
      ++left;
    }
  }
  m_information = vpPoseMatrix6::Identity() / (m_prior * m_prior);
  m_gradient.setZero();
  for (std::size_t step = 0; step < std::min(left, decisive); ++step) {
    estimate();
    const std::size_t i = pick(classes, random);
    draw.classes[i] = drawClass(classes, contours[i], random);
    believe(classes.at(contours[i], draw.classes[i]));
  }
  estimate();
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (m_open[i] != 0) {
      draw.classes[i] = likeliestClass(classes, contours[i]);
    }
  }
}

// The motion from all classes of the draw, and how well they agree with it.
void vpClassDraw::conclude(const vpContourClasses &classes, Draw &draw)
{
  const std::vector<vpContourClasses::Contour> &contours = classes.contours();
  m_information = vpPoseMatrix6::Identity() / (m_prior * m_prior);
  m_gradient.setZero();
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (draw.classes[i] >= 0) {
      believe(classes.at(contours[i], draw.classes[i]));
    }
  }
  estimate();
  draw.motion = m_motion;
  const double cutoff = vpPoseHypotheses::cutoff * vpPoseHypotheses::cutoff;
  double sum = 0.;
  int points = 0;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const int size = draw.classes[i] < 0 ? 0 : classes.at(contours[i], draw.classes[i]).size;
    points += contours[i].count;
    sum += (contours[i].count - size) * cutoff;
    if (size > 0) {
      sum += size * std::min(classes.at(contours[i], draw.classes[i]).error(m_motion), cutoff);
    }
  }
  draw.error = points > 0 ? sum / points : cutoff;
}

END_VISP_NAMESPACE
