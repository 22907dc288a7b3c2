// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpPoseScore.h"

#include <algorithm>
#include <array>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Where colours are looked at on both sides of the silhouette: shares of the object's size in the image.
const std::array<float, 3> offsets = {{0.012F, 0.03F, 0.06F}};
const float leastOffset = 1.5F; // Pixels, times the place among them.
// Logarithms of odds beyond this say no more, and colours that separate this well are as good as any.
const float fullOdds = 2.F;
// With less of the outline in the image there is nothing to go by.
const double leastInside = 0.15;
// What is outside the image supports nothing: of a pose that is just about to leave it.
const double outsideCost = 0.2;
} // namespace

struct vpPoseScore::Sums
{
  double distance = 0.;
  double color = 0.;
  int points = 0;
  int rims = 0;
};

void vpPoseScore::setImage(const vpOrientedDistanceMap *edges, const vpColorOddsMap *colors,
                           const vpSurfaceMemory *surface, const vpCameraParameters &cam, unsigned int width,
                           unsigned int height)
{
  m_edges = edges;
  m_colors = colors;
  m_surface = surface;
  m_camera = vpPointCamera(cam, width, height);
}

// By how much the colours inside speak more for the object than those outside, [-1, 1].
float vpPoseScore::separation(const vpSeenPoint &point, float reach) const
{
  const auto odds = [&](float offset) {
    const float at = m_colors->logOdds(point.u + offset * point.normalU, point.v + offset * point.normalV);
    return std::min(std::max(at, -fullOdds), fullOdds);
  };
  float difference = 0.F;
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    const float offset = std::max(offsets[k] * reach, leastOffset * static_cast<float>(k + 1)) / point.length;
    difference += odds(-offset) - odds(offset);
  }
  return difference / (2.F * static_cast<float>(offsets.size()) * fullOdds);
}

void vpPoseScore::addPoint(const vpSeenPoint &point, bool isSilhouette, float reach, Sums &sums) const
{
  ++sums.points;
  if (m_edges != nullptr) {
    sums.distance += m_edges->distance(point.u, point.v, vpOrientedDistanceMap::bin(point.normalU, point.normalV));
  }
  if (m_colors == nullptr || !isSilhouette) {
    return;
  }
  if (point.length > 0.F) {
    ++sums.rims;
    sums.color += separation(point, reach);
  }
}

void vpPoseScore::combine(const Sums &sums, const vpHomogeneousMatrix &cMo, Value &value) const
{
  double total = 0.;
  double weight = 0.;
  if (m_edges != nullptr) {
    value.distance = sums.distance / (sums.points * m_edges->settings().maxDistance);
    total += m_weights[0] * (1. - value.distance);
    weight += m_weights[0];
  }
  if (m_colors != nullptr && sums.rims > 0) {
    value.color = sums.color / sums.rims;
    total += m_weights[1] * value.color;
    weight += m_weights[1];
  }
  if (m_surface != nullptr && m_surface->texture() > 0.) {
    const vpSurfaceMemory::Agreement agreement = m_surface->agreement(cMo);
    const double trust = m_weights[2] * vpSurfaceTrust(m_surface->texture());
    value.surface = agreement.known * agreement.correlation + (1. - agreement.known) * vpUnknownCorrelation;
    total += trust * value.surface;
    weight += trust;
  }
  value.total = weight > 0. ? total / weight - outsideCost * (1. - value.inside) : 0.;
}

vpPoseScore::Value vpPoseScore::at(const vpHomogeneousMatrix &cMo, unsigned int level) const
{
  Value value;
  const double *m = cMo.data; // Its operators are no inline functions.
  const vpTrackedModel &model = m_sphere->model();
  const Eigen::Vector3d centre = model.centre();
  const double depth = m[8] * centre.x() + m[9] * centre.y() + m[10] * centre.z() + m[11];
  if (!(depth > 0.)) {
    return value;
  }
  const vpSphereView &view = m_sphere->view(m_sphere->nearest(cMo, level));
  if (view.size() == 0) {
    return value;
  }
  vpPointProjection::Pose pose;
  std::transform(m, m + pose.size(), pose.begin(), [](double number) { return static_cast<float>(number); });
  vpPointProjection projection(pose, m_camera);
  const float reach = m_camera.px * static_cast<float>(model.diameter() / depth);
  Sums sums;
  projection.forEachSeen(view, view.size(), [&](const vpSeenPoint &point) {
    addPoint(point, point.number < view.silhouettes(), reach, sums);
  });
  value.inside = static_cast<double>(sums.points) / static_cast<double>(view.size());
  value.isSeen = value.inside >= leastInside;
  if (value.isSeen) {
    combine(sums, cMo, value);
  }
  return value;
}

END_VISP_NAMESPACE
