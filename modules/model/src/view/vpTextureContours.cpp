// SPDX-License-Identifier: GPL-2.0-or-later
#include "view/vpTextureContours.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Print that is seen more from the side than this is too narrow in the image to tell its edges apart; cosine of 75
// degrees.
const double leastFacing = 0.259;
// Parallel edges nearer than this are mistaken for one another, pixels.
const double apart = 6.;
// Print nearer than this beside an edge moves the edge that a gradient filter finds, pixels.
const double leastClearance = 4.;
// Fewer control points in a row tell little.
const int fewestPoints = 3;
} // namespace

vpTextureContours::vpTextureContours(vpModelView &view, const vpViewCamera &camera, const vpModelViewOptions &options)
    : m_view(view), m_camera(camera), m_options(options),
      m_grid(camera.width, camera.height, apart, view.m_cells, view.m_cellNext)
{
  m_grid.add(view.m_points);
}

bool vpTextureContours::isSeen(const vpTextureEdge &edge) const
{
  const Eigen::Vector3d toCamera = m_camera.oC - 0.5 * (edge.position[0] + edge.position[1]);
  const double facing = edge.normal.dot(toCamera) / toCamera.norm();
  return (edge.oriented ? facing : std::fabs(facing)) > leastFacing && clearance(edge) > leastClearance;
}

// Distance of the print beside an edge in the image, pixels.
double vpTextureContours::clearance(const vpTextureEdge &edge) const
{
  const Eigen::Vector3d middle = 0.5 * (edge.position[0] + edge.position[1]);
  const Eigen::Vector3d along = (edge.position[1] - edge.position[0]).normalized();
  const Eigen::Vector3d cX = m_camera.toCamera(middle);
  if (cX.z() < m_options.nearDistance) {
    return 0.;
  }
  const auto motion = [&](const Eigen::Vector3d &direction) {
    const Eigen::Vector3d d = m_camera.cRo * direction;
    return Eigen::Vector2d(m_camera.px * (d.x() - d.z() * cX.x() / cX.z()) / cX.z(),
                           m_camera.py * (d.y() - d.z() * cX.y() / cX.z()) / cX.z());
  };
  const Eigen::Vector2d beside = motion(edge.normal.cross(along) * edge.clearance);
  const Eigen::Vector2d tangent = motion(along).normalized();
  return std::fabs(beside.x() * tangent.y() - beside.y() * tangent.x());
}

void vpTextureContours::add(const std::vector<vpTextureEdge> &edges, int firstName, vpContourSampler &sampler)
{
  // The texture shall help the geometry, not outvote it.
  const std::size_t most = 2 * m_view.m_points.size();
  for (std::size_t i = 0; i < edges.size() && m_view.m_points.size() < most; ++i) {
    const bool leftOut = i < m_options.textureEdgesLeftOut.size() && m_options.textureEdgesLeftOut[i] != 0;
    if (leftOut || !isSeen(edges[i])) {
      continue;
    }
    const std::size_t firstContour = m_view.m_contours.size();
    const Eigen::Vector3d direction = (edges[i].position[1] - edges[i].position[0]).normalized();
    vpModelView::Piece piece;
    piece.position = edges[i].position;
    piece.direction = {{direction, direction}};
    piece.outward = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}};
    piece.parameter = {{0., 1.}};
    piece.edge = firstName + static_cast<int>(i);
    piece.innerEdge = true;
    sampler.add(piece);
    sampler.sample(true);
    keepUnambiguous(firstContour);
    m_grid.add(m_view.m_points);
  }
}

// Of each new contour, the longest run of points that no edge before it can be mistaken for.
void vpTextureContours::keepUnambiguous(std::size_t firstContour)
{
  std::vector<vpContour> &contours = m_view.m_contours;
  std::vector<vpControlPoint> &points = m_view.m_points;
  if (firstContour == contours.size()) {
    return;
  }
  const std::size_t count = contours.size() - firstContour;
  std::size_t keptContours = firstContour;
  std::size_t keptPoints = static_cast<std::size_t>(contours[firstContour].first);
  for (std::size_t c = firstContour; c < firstContour + count; ++c) {
    const vpContour run = longestRun(contours[c]);
    if (run.count < fewestPoints) {
      continue;
    }
    vpContour &kept = contours[keptContours];
    kept = run;
    kept.first = static_cast<int>(keptPoints);
    for (int i = 0; i < run.count; ++i) {
      vpControlPoint &point = points[keptPoints++];
      point = points[static_cast<std::size_t>(run.first + i)];
      point.contour = static_cast<int>(keptContours);
      point.arcLength = (i + 0.5) * run.step;
    }
    ++keptContours;
  }
  contours.erase(contours.begin() + static_cast<std::ptrdiff_t>(keptContours), contours.end());
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(keptPoints), points.end());
}

vpContour vpTextureContours::longestRun(const vpContour &contour) const
{
  vpContour best = contour;
  best.count = 0;
  vpContour run = best;
  for (int i = contour.first; i < contour.first + contour.count; ++i) {
    if (m_grid.hasParallel(m_view.m_points, m_view.m_points[static_cast<std::size_t>(i)])) {
      run.count = 0;
      continue;
    }
    if (run.count++ == 0) {
      run.first = i;
    }
    if (run.count > best.count) {
      best = run;
    }
  }
  return best;
}

END_VISP_NAMESPACE
