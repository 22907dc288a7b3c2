// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpEdgeClustering.h>

#include "edge/vpClassAssignment.h"
#include "edge/vpNormalEquations.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const int maxIterations = 12;
// Steps of the robust least squares: from nothing, and from the mean of the iteration before.
const int freshSteps = 4;
const int nextSteps = 2;
// Fewer members than this make no class, however short the contour is.
const int fewestMembers = 3;
// A polynomial of third order can follow half a turn; each coefficient needs points of its own.
const double turnPerOrder = 0.7; // Radians.
const int pointsPerCoefficient = 3;

// Residues that differ by less are the same but for rounding.
const double sameResidue = 1e-3; // Pixels.

void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpEdgeClustering::Settings::%s is %g, it must be %s", member, value,
                      range);
  }
}
} // namespace

vpEdgeClustering::vpEdgeClustering(const Settings &settings) : m_settings(settings)
{
  require(settings.noise > 0., "noise", settings.noise, "above 0 pixels");
  require(settings.cutoff > 0., "cutoff", settings.cutoff, "above 0 pixels");
  require(settings.smallestShare >= 0. && settings.smallestShare <= 1., "smallestShare", settings.smallestShare,
          "in [0, 1]");
}

void vpEdgeClustering::begin(Shape shape, double turn)
{
  m_shape = shape;
  m_points.clear();
  m_classes.clear();
  m_k = 0;
  m_iterations = 0;
  switch (shape) {
  case Shape::STRAIGHT:
    m_wantedOrder = 2;
    break;
  case Shape::OPEN_CURVE:
    m_wantedOrder = 2 + std::min(static_cast<int>(std::ceil(turn / turnPerOrder)), 2);
    break;
  case Shape::CLOSED_CURVE:
    m_wantedOrder = maxCoefficients;
    break;
  }
}

void vpEdgeClustering::add(double arcLength, const double *offsets, int count)
{
  m_points.emplace_back();
  Point &point = m_points.back();
  point.arcLength = arcLength;
  point.count = std::min(count, maxClasses);
  for (int i = 0; i < point.count; ++i) {
    // Few candidates: each is moved to its place among those before it.
    int at = i;
    for (; at > 0 && point.offset[static_cast<std::size_t>(at - 1)] > offsets[i]; --at) {
      point.offset[static_cast<std::size_t>(at)] = point.offset[static_cast<std::size_t>(at - 1)];
      point.source[static_cast<std::size_t>(at)] = point.source[static_cast<std::size_t>(at - 1)];
    }
    point.offset[static_cast<std::size_t>(at)] = offsets[i];
    point.source[static_cast<std::size_t>(at)] = i;
  }
  for (int i = 0; i < point.count; ++i) {
    point.label[static_cast<std::size_t>(i)] = i;
  }
  m_k = std::max(m_k, point.count);
}

vpEdgeClustering::Coefficients vpEdgeClustering::basis(double arcLength) const
{
  Coefficients b = Coefficients::Zero();
  const double s = (arcLength - m_middle) / m_halfLength;
  b(0) = 1.;
  if (m_shape == Shape::CLOSED_CURVE && m_order >= 3) {
    // A motion of the whole curve has one wave around it, a change of its form two.
    const double angle = M_PI * s;
    b(1) = std::cos(angle);
    b(2) = std::sin(angle);
    if (m_order == maxCoefficients) {
      b(3) = std::cos(2. * angle);
      b(4) = std::sin(2. * angle);
    }
    return b;
  }
  if (m_order > 1) {
    b(1) = s;
  }
  // Legendre's polynomials, so that the normal equations stay well conditioned.
  if (m_order > 2) {
    b(2) = 1.5 * s * s - 0.5;
  }
  if (m_order > 3) {
    b(3) = (2.5 * s * s - 1.5) * s;
  }
  return b;
}

void vpEdgeClustering::prepareBasis()
{
  const int affordable = static_cast<int>(m_points.size()) / pointsPerCoefficient;
  m_order = std::max(std::min(m_wantedOrder, affordable), std::min(2, m_wantedOrder));
  if (m_shape == Shape::CLOSED_CURVE && m_order == 4) {
    m_order = 3; // Sine and cosine come together.
  }
  const double first = m_points.front().arcLength;
  const double last = m_points.back().arcLength;
  // Of a closed curve the step from the last point to the first is part of it.
  const double gap = m_shape == Shape::CLOSED_CURVE && m_points.size() > 1
                         ? (last - first) / static_cast<double>(m_points.size() - 1)
                         : 0.;
  m_middle = 0.5 * (first + last);
  m_halfLength = std::max(0.5 * (last - first + gap), 1.);
  for (Point &point : m_points) {
    point.basis = basis(point.arcLength);
  }
}

double vpEdgeClustering::displacement(int label, double arcLength) const
{
  return basis(arcLength).dot(m_classes[static_cast<std::size_t>(label)].mean);
}

// Huber's estimator of the members' curve, by least squares whose weights follow the residuals: it has one solution,
// whatever it starts from. \return False without members.
bool vpEdgeClustering::fit(int label, Coefficients &mean, double noise, bool fresh) const
{
  bool found = false;
  const auto step = [&](auto equations, bool weighted) {
    for (const Point &point : m_points) {
      // The order along the normal tells most where nothing is missing.
      const double order = static_cast<double>(point.count) / m_k;
      const double complete = fresh ? order * order * order * order : 1.;
      for (int i = 0; i < point.count; ++i) {
        if (point.label[static_cast<std::size_t>(i)] == label) {
          const double offset = point.offset[static_cast<std::size_t>(i)];
          const double residual = weighted ? std::fabs(offset - point.basis.dot(mean)) : 0.;
          equations.add(point.basis, offset, complete * noise / std::max(residual, noise));
          found = true;
          break;
        }
      }
    }
    equations.solve(mean);
  };
  const int steps = fresh ? freshSteps : nextSteps;
  for (int i = 0; i < steps; ++i) {
    const bool weighted = !fresh || i > 0;
    switch (m_order) {
    case 1:
      step(vpNormalEquations<1>(), weighted);
      break;
    case 2:
      step(vpNormalEquations<2>(), weighted);
      break;
    case 3:
      step(vpNormalEquations<3>(), weighted);
      break;
    case 4:
      step(vpNormalEquations<4>(), weighted);
      break;
    default:
      step(vpNormalEquations<5>(), weighted);
      break;
    }
    if (!found) {
      return false;
    }
  }
  return true;
}

// \return True where a label changed.
bool vpEdgeClustering::assign(Point &point, bool cut) const
{
  vpClassAssignment<maxClasses> classes;
  for (int label = 0; label < m_k; ++label) {
    if (m_alive[static_cast<std::size_t>(label)]) {
      classes.add(label, point.basis.dot(m_means[static_cast<std::size_t>(label)]));
    }
  }
  const double limit = cut ? m_settings.cutoff + m_settings.noise : HUGE_VAL;
  return classes.assign(point.offset.data(), point.count, limit, point.label.data());
}

void vpEdgeClustering::compute()
{
  if (m_points.empty() || m_k == 0) {
    return;
  }
  prepareBasis();
  m_alive.fill(true);
  bool changed = true;
  for (m_iterations = 0; changed && m_iterations < maxIterations; ++m_iterations) {
    for (int label = 0; label < m_k; ++label) {
      const std::size_t index = static_cast<std::size_t>(label);
      m_alive[index] = m_alive[index] && fit(label, m_means[index], m_settings.noise, m_iterations == 0);
    }
    // The first means may lie between two edges. Until they were moved, every candidate takes part.
    const bool cut = m_iterations > 0;
    changed = false;
    for (Point &point : m_points) {
      changed = assign(point, cut) || changed;
    }
  }
  collect();
}

void vpEdgeClustering::describe(Class &found, int label) const
{
  const double cutoff = m_settings.cutoff * m_settings.cutoff;
  double sum = 0.;
  for (const Point &point : m_points) {
    double squared = cutoff;
    for (int i = 0; i < point.count; ++i) {
      if (point.label[static_cast<std::size_t>(i)] == label) {
        const double distance = point.offset[static_cast<std::size_t>(i)] - point.basis.dot(found.mean);
        if (distance * distance < cutoff) {
          squared = distance * distance;
          ++found.size;
        }
        break;
      }
    }
    sum += squared;
  }
  found.residue = std::sqrt(sum / static_cast<double>(m_points.size()));
}

void vpEdgeClustering::collect()
{
  const double smallest =
      std::max(m_settings.smallestShare * static_cast<double>(m_points.size()), static_cast<double>(fewestMembers));
  std::array<int, maxClasses> labels{};
  int count = 0;
  for (int label = 0; label < m_k; ++label) {
    Class found;
    found.mean = m_means[static_cast<std::size_t>(label)];
    if (m_alive[static_cast<std::size_t>(label)]) {
      describe(found, label);
    }
    if (found.size >= smallest) {
      m_classes.push_back(found);
      labels[static_cast<std::size_t>(count++)] = label;
    }
  }
  const double cutoff = m_settings.cutoff;
  for (int c = 0; c < count; ++c) {
    std::vector<int> &members = m_members[static_cast<std::size_t>(c)];
    members.clear();
    for (const Point &point : m_points) {
      int member = -1;
      for (int i = 0; i < point.count; ++i) {
        const std::size_t at = static_cast<std::size_t>(i);
        if (point.label[at] == labels[static_cast<std::size_t>(c)] &&
            std::fabs(point.offset[at] - point.basis.dot(m_classes[static_cast<std::size_t>(c)].mean)) < cutoff) {
          member = point.source[at];
        }
      }
      members.push_back(member);
    }
  }
}

void vpEdgeClustering::drawWeights(double lambda, std::vector<double> &weights) const
{
  weights.clear();
  double least = HUGE_VAL;
  double most = 0.;
  for (const Class &c : m_classes) {
    least = std::min(least, c.residue);
    most = std::max(most, c.residue);
  }
  for (const Class &c : m_classes) {
    const double share = most - least > sameResidue ? (c.residue - least) / (most - least) : 0.;
    weights.push_back(std::exp(-lambda * share * share));
  }
}

END_VISP_NAMESPACE
