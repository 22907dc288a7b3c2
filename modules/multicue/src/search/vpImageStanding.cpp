// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpImageStanding.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// How near an edge has to be to a contour, of the object's size, and pixels.
const double reachShare = 0.06;
const double leastReach = 3.;
const double mostReach = 12.;
const unsigned int valuedLevel = 3; // Of the sphere.
const double leastInside = 0.3;     // Share of the contours in the image.
const double outsideCost = 0.2;
} // namespace

void vpImageStanding::setFrame(const vpCueFrame &frame, vpViewSphere &sphere, const vpOrientedDistanceMap &edges,
                               const vpStartSearch &look)
{
  m_look = &look;
  m_edges = &edges;
  m_sphere = &sphere;
  m_camera = vpPointCamera(frame.camera(), frame.width(), frame.height());
  m_usual.clear();
}

double vpImageStanding::sizeOf(const Eigen::Isometry3d &cMo) const
{
  const double depth = (cMo * m_sphere->model().centre()).z();
  return depth > 0. ? static_cast<double>(m_camera.px) * m_sphere->model().diameter() / depth : 0.;
}

// Mean over the contours of how near the image's edges are; 1 where they are there.
double vpImageStanding::edgesAt(const Eigen::Isometry3d &cMo, double size, double &inside) const
{
  const double reach = std::min(std::max(reachShare * size, leastReach), mostReach);
  const Eigen::Vector3d sight = cMo.linear().transpose() * -(cMo * m_sphere->model().centre());
  const vpSphereView &view = m_sphere->view(m_sphere->nearest(sight, valuedLevel));
  double sum = 0.;
  int points = 0;
  vpPointProjection(cMo, m_camera).forEachSeen(view, view.size(), [&](const vpSeenPoint &point) {
    const int bin = vpOrientedDistanceMap::bin(point.normalU, point.normalV);
    ++points;
    sum += std::max(1. - m_edges->distance(point.u, point.v, bin) / reach, 0.);
  });
  inside = view.size() > 0 ? static_cast<double>(points) / static_cast<double>(view.size()) : 0.;
  return points > 0 ? sum / points : 0.;
}

// How well the image agrees with a pose, about 1 where it is right; without regard to its size.
double vpImageStanding::value(const Eigen::Isometry3d &cMo, std::size_t every) const
{
  const double size = sizeOf(cMo);
  double inside = 0.;
  const double edges = size > 0. ? edgesAt(cMo, size, inside) : 0.;
  if (inside < leastInside) {
    return -1.;
  }
  const double trust = m_look->trust();
  const double colors = trust > 0. ? m_look->colorsAt(cMo, every) : 0.;
  return (edges + trust * colors) / (1. + trust) - outsideCost * (1. - inside);
}

double vpImageStanding::usualOf(double size) const
{
  const auto larger = std::find_if(m_usual.begin(), m_usual.end(), [size](const Usual &u) { return u.size > size; });
  if (larger == m_usual.begin() || larger == m_usual.end()) {
    return m_usual.empty() ? 0. : larger == m_usual.end() ? m_usual.back().mean : larger->mean;
  }
  const Usual &smaller = *(larger - 1);
  const double share = std::log(size / smaller.size) / std::log(larger->size / smaller.size);
  return smaller.mean + share * (larger->mean - smaller.mean);
}

double vpImageStanding::operator()(const vpHomogeneousMatrix &cMo, std::size_t every) const
{
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo);
  const double size = sizeOf(pose);
  return size > 0. ? (value(pose, every) - usualOf(size)) / deviation : -HUGE_VAL;
}

END_VISP_NAMESPACE
