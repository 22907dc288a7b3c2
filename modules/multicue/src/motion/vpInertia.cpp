// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/vpInertia.h"

#include <Eigen/Geometry>

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
const double leastDeviation = 0.005; // Of a frame, in diameters or radians.
const int mostFrames = 8;            // For which another motion is doubted.
} // namespace

void vpInertia::predict(double time, const Eigen::Vector3d &centre, double diameter)
{
  m_isPredicted = m_frames != none;
  if (m_isPredicted) {
    ++m_frames;
    m_centre = centre;
    m_diameter = diameter;
    m_cMo = vpEvenMotion(m_state.cMo, m_state.velocity, centre, time - m_state.time);
  }
}

// Squared, in deviations, which add up over the frames since the state.
double vpInertia::surprise(const vpHomogeneousMatrix &cMo) const
{
  const Eigen::Isometry3d moved = vpPoseExponential::toEigen(m_cMo.inverse() * cMo);
  const auto deviation = [this](std::size_t i) { return std::max(m_state.deviation[i], leastDeviation) * m_frames; };
  const double distance = (moved * m_centre - m_centre).norm() / (m_diameter * deviation(0));
  const double angle = Eigen::AngleAxisd(moved.linear()).angle() / deviation(1);
  return distance * distance + angle * angle;
}

void vpInertia::update(const State &state)
{
  if (isLeftBy(state.cMo) && m_frames < mostFrames) {
    return;
  }
  m_state = state;
  m_frames = 0;
}

END_VISP_NAMESPACE
