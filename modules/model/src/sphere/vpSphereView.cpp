// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpSphereView.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

// Control points come contour by contour and evenly spaced on each, so every n-th of the list is spread evenly over all
// of them. What does not divide is spread as well: the k-th taken is the one at the middle of the k-th part of the
// list.
vpSphereView::vpSphereView(const std::vector<vpControlPoint> &points, std::size_t most)
    : m_size(std::min(points.size(), most))
{
  m_values.resize(arrays * m_size);
  const auto taken = [&](std::size_t k) -> const vpControlPoint & {
    return points[(2 * k + 1) * points.size() / (2 * m_size)];
  };
  for (std::size_t k = 0; k < m_size; ++k) {
    m_silhouettes += taken(k).kind == vpEdgeKind::SILHOUETTE ? 1U : 0U;
  }
  std::size_t nextSilhouette = 0;
  std::size_t nextInner = m_silhouettes;
  for (std::size_t k = 0; k < m_size; ++k) {
    std::size_t &next = taken(k).kind == vpEdgeKind::SILHOUETTE ? nextSilhouette : nextInner;
    set(next++, taken(k));
  }
}

void vpSphereView::set(std::size_t i, const vpControlPoint &point)
{
  for (std::size_t k = 0; k < 3; ++k) {
    m_values[k * m_size + i] = static_cast<float>(point.position[static_cast<Eigen::Index>(k)]);
    m_values[(3 + k) * m_size + i] = static_cast<float>(point.direction[static_cast<Eigen::Index>(k)]);
  }
  m_values[6 * m_size + i] = static_cast<float>(point.side);
}

vpSphereViewPoint vpSphereView::point(std::size_t i) const
{
  vpSphereViewPoint point;
  point.position = Eigen::Vector3f(x()[i], y()[i], z()[i]);
  point.direction = Eigen::Vector3f(dx()[i], dy()[i], dz()[i]);
  point.side = side()[i];
  point.silhouette = i < m_silhouettes;
  return point;
}

END_VISP_NAMESPACE
