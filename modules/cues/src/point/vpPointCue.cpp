// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/cues/vpPointCue.h>

#include "point/vpPointTracks.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// What a point's place in the image is uncertain by even where all is well, pixels.
const double pointNoise = 0.3;
const std::size_t rowsPerPoint = 2;
// How far a new point may be from where the pose has it, pixels.
const double agreement = 2.;
} // namespace

class vpPointCue::Impl
{
public:
  explicit Impl(const vpPointCueSettings &settings) : tracks(settings) {}

  // A point that gave no row, with a pose that it had no part in.
  bool agrees(const Match &match, const vpPointCamera &at) const
  {
    const Eigen::Vector3d cX = at.toCamera(match.position);
    return cX.z() > 0. && (at.project(cX) - match.pixel).norm() < agreement;
  }

  std::size_t found() const
  {
    return static_cast<std::size_t>(
        std::count_if(matches.begin(), matches.end(), [](const Match &match) { return match.found && match.proven; }));
  }

  vpPointTracks tracks;
  vpCameraParameters camera; // Of the last match.
  std::vector<Match> matches;
  std::vector<char> trusted;
  DepthSource depthSource;
};

bool vpPointCue::isAvailable()
{
  return true;
}

vpPointCue::vpPointCue(const vpPointCueSettings &settings)
{
  settings.check();
  m_impl = std::make_unique<Impl>(settings);
}

vpPointCue::~vpPointCue() = default;

void vpPointCue::setSettings(const vpPointCueSettings &settings)
{
  settings.check();
  const SurfaceFilter filter = m_impl->tracks.filter();
  m_impl->tracks = vpPointTracks(settings);
  m_impl->tracks.setFilter(filter);
}

const vpPointCueSettings &vpPointCue::settings() const
{
  return m_impl->tracks.settings();
}

void vpPointCue::setDepthSource(const DepthSource &source)
{
  m_impl->depthSource = source;
}

void vpPointCue::setSurfaceFilter(const SurfaceFilter &filter)
{
  m_impl->tracks.setFilter(filter);
}

bool vpPointCue::wantsPoints() const
{
  return m_impl->depthSource && m_impl->tracks.wantsPoints();
}

const std::vector<vpPointCue::Match> &vpPointCue::matches() const
{
  return m_impl->matches;
}

std::size_t vpPointCue::pointCount() const
{
  return m_impl->tracks.size();
}

void vpPointCue::reset()
{
  m_impl->tracks.forget();
}

void vpPointCue::match(const vpCueFrame &frame, const vpModelView &view)
{
  m_impl->camera = frame.camera();
  m_impl->tracks.match(frame, view, m_impl->matches);
}

void vpPointCue::residuals(const vpHomogeneousMatrix &cMo, vpResidualBlock &block) const
{
  block.rows.clear();
  block.noise = pointNoise / m_impl->camera.get_px();
  const vpPointCamera camera(cMo, m_impl->camera);
  for (const Match &match : m_impl->matches) {
    if (!match.found || !match.proven) {
      continue;
    }
    block.rows.resize(block.rows.size() + rowsPerPoint);
    vpResidual &rowX = *(block.rows.end() - 2);
    vpResidual &rowY = *(block.rows.end() - 1);
    rowX = rowY = vpResidual();
    rowX.onSurface = rowY.onSurface = true;
    const Eigen::Vector3d cX = camera.toCamera(match.position);
    if (!(cX.z() > 0.)) {
      rowX.weight = rowY.weight = 0.;
      continue;
    }
    const double near = 1. / cX.z();
    const double x = cX.x() * near;
    const double y = cX.y() * near;
    const Eigen::Vector2d place = camera.normalized(match.pixel);
    rowX.error = x - place.x(); // [P14] eq. 10
    rowY.error = y - place.y();
    rowX.jacobian << -near, 0., x * near, x * y, -(1. + x * x), y; // [P14] eq. 11
    rowY.jacobian << 0., -near, y * near, 1. + y * y, -x * y, -x;
  }
}

void vpPointCue::updateReference(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights)
{
  Impl &impl = *m_impl;
  if (weights.size() != rowsPerPoint * impl.found()) {
    throw vpException(
        vpException::dimensionError,
        "vpPointCue::updateReference() was given %zu weights for %zu rows: pass one for each of residuals()",
        weights.size(), rowsPerPoint * impl.found());
  }
  impl.trusted.clear();
  const double leastWeight = settings().leastWeight;
  const vpPointCamera camera(cMo, impl.camera);
  std::size_t row = 0;
  for (const Match &match : impl.matches) {
    if (match.found && match.proven) {
      impl.trusted.push_back(weights[row] > leastWeight && weights[row + 1] > leastWeight);
      row += rowsPerPoint;
    } else {
      impl.trusted.push_back(match.found && impl.agrees(match, camera));
    }
  }
  impl.tracks.learn(cMo, impl.matches, impl.trusted, impl.depthSource);
}

void vpPointCue::getFeatures(const vpHomogeneousMatrix &, const std::vector<double> &weights,
                             std::vector<vpCueFeature> &features) const
{
  features.clear();
  std::size_t row = 0;
  for (const Match &match : m_impl->matches) {
    vpCueFeature feature;
    feature.u = match.pixel.x();
    feature.v = match.pixel.y();
    feature.state = match.found ? vpFeatureState::GOOD : vpFeatureState::CONTRAST;
    if (match.found && match.proven) {
      const bool isRefused =
          row + 1 < weights.size() && std::min(weights[row], weights[row + 1]) <= settings().leastWeight;
      feature.state = isRefused ? vpFeatureState::OUTLIER : vpFeatureState::GOOD;
      row += rowsPerPoint;
    }
    features.push_back(feature);
  }
}

END_VISP_NAMESPACE
