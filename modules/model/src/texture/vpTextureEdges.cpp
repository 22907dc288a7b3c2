// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpTextureEdges.h>

#include "texture/vpEdgePixels.h"

#include <visp3/core/vpException.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Deviations from a straight line: of any point before the chain is cut there, and of all on the average, pixels.
const double largestDeviation = 0.7;
const double meanDeviation = 0.35;
// Left out at both ends of a straight bit, where corners round the edge off, pixels.
const std::size_t cornerPixels = 2;
// For the surface's normal, pixels.
const double normalStep = 2.;
// What is farther than this beside an edge does not matter to it, pixels.
const double largestClearance = 40.;
// Weaker pixels connect the strong ones of an edge; share of the smallest contrast.
const double weakest = 0.5;

void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpTextureEdgeOptions::%s is %g, it must be %s", member, value, range);
  }
}

//! An edge pixel on the surface.
struct SurfacePoint
{
  Eigen::Vector3d position;
  const vpEdgePixel *pixel;
};

//! A line through points of the surface, by least squares.
struct FittedLine
{
  FittedLine(const SurfacePoint *first, const SurfacePoint *last)
  {
    const double count = static_cast<double>(last - first);
    for (const SurfacePoint *point = first; point != last; ++point) {
      centre += point->position / count;
    }
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    for (const SurfacePoint *point = first; point != last; ++point) {
      const Eigen::Vector3d d = point->position - centre;
      scatter += d * d.transpose() / count;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
    direction = solver.eigenvectors().col(2);
    deviation = std::sqrt(std::max(solver.eigenvalues()[0] + solver.eigenvalues()[1], 0.));
  }
  Eigen::Vector3d nearest(const Eigen::Vector3d &p) const { return centre + direction * direction.dot(p - centre); }

  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction;
  double deviation = 0.; //!< Root mean square.
};

/*!
  Cuts the chains of one chart into straight edges on the surface.
*/
class EdgeFitter
{
public:
  EdgeFitter(const vpChartImage &image, const vpEdgePixels &pixels, bool oriented, double pixel,
             const vpTextureEdgeOptions &options, std::vector<vpTextureEdge> &edges)
      : m_image(image), m_pixels(pixels), m_oriented(oriented), m_pixel(pixel), m_options(options), m_edges(edges)
  {
  }

  void add(const std::vector<int> &chain)
  {
    std::vector<SurfacePoint> points;
    points.reserve(chain.size());
    for (const int i : chain) {
      const vpEdgePixel &pixel = m_pixels.pixels()[static_cast<std::size_t>(i)];
      points.push_back({m_image.toObject(pixel.place.x(), pixel.place.y()), &pixel});
    }
    if (!points.empty()) {
      split(points.data(), points.data() + points.size());
    }
  }

private:
  // After Douglas and Peucker: cut where the chain is farthest from the line between its ends.
  void split(const SurfacePoint *first, const SurfacePoint *last)
  {
    if (last - first < 4) {
      return;
    }
    const Eigen::Vector3d &a = first->position;
    const Eigen::Vector3d along = ((last - 1)->position - a).normalized();
    const SurfacePoint *farthest = first;
    double largest = 0.;
    for (const SurfacePoint *point = first + 1; point + 1 < last; ++point) {
      const Eigen::Vector3d d = point->position - a;
      const double deviation = (d - along * along.dot(d)).norm();
      if (deviation > largest) {
        largest = deviation;
        farthest = point;
      }
    }
    if (largest <= largestDeviation * m_pixel) {
      fit(first + cornerPixels, last - cornerPixels);
    } else {
      split(first, farthest + 1);
      split(farthest, last);
    }
  }

  void fit(const SurfacePoint *first, const SurfacePoint *last)
  {
    if (last - first < 4) {
      return;
    }
    const FittedLine line(first, last);
    vpTextureEdge edge;
    edge.position = {{line.nearest(first->position), line.nearest((last - 1)->position)}};
    for (const SurfacePoint *point = first; point != last; ++point) {
      edge.contrast += point->pixel->contrast / static_cast<double>(last - first);
    }
    const double length = (edge.position[1] - edge.position[0]).norm();
    if (line.deviation > meanDeviation * m_pixel || length < m_options.minLength * m_options.resolution * m_pixel ||
        edge.contrast < m_options.minContrast) {
      return;
    }
    const vpEdgePixel &middle = *first[(last - first) / 2].pixel;
    edge.normal = m_image.normal(middle.place.x(), middle.place.y(), normalStep);
    edge.oriented = m_oriented;
    edge.clearance = clearance(first, last) * m_pixel;
    turn(edge, middle);
    m_edges.push_back(edge);
  }

  // That most of the points have, pixels.
  double clearance(const SurfacePoint *first, const SurfacePoint *last) const
  {
    std::vector<double> distances;
    for (const SurfacePoint *point = first; point != last; ++point) {
      distances.push_back(m_pixels.clearance(*point->pixel, largestClearance));
    }
    const auto quarter = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 4);
    std::nth_element(distances.begin(), quarter, distances.end());
    return *quarter;
  }

  // Has the brighter side on the left.
  void turn(vpTextureEdge &edge, const vpEdgePixel &pixel) const
  {
    const Eigen::Vector2d ahead = pixel.place + normalStep * pixel.gradient;
    const Eigen::Vector3d brighter =
        m_image.toObject(ahead.x(), ahead.y()) - m_image.toObject(pixel.place.x(), pixel.place.y());
    if (edge.normal.cross(edge.position[1] - edge.position[0]).dot(brighter) < 0.) {
      std::swap(edge.position[0], edge.position[1]);
    }
  }

  const vpChartImage &m_image;
  const vpEdgePixels &m_pixels;
  bool m_oriented;
  double m_pixel;
  const vpTextureEdgeOptions &m_options;
  std::vector<vpTextureEdge> &m_edges;
};

double merit(const vpTextureEdge &edge)
{
  return edge.contrast * (edge.position[1] - edge.position[0]).norm();
}
} // namespace

void vpTextureEdgeOptions::check() const
{
  require(resolution >= 50. && resolution <= 4000., "resolution", resolution, "in [50, 4000] pixels per diameter");
  require(minContrast > 0. && minContrast <= 255., "minContrast", minContrast, "in (0, 255] gray levels");
  require(minLength > 0. && minLength <= 1., "minLength", minLength, "a share of the diameter in (0, 1]");
  require(maxEdges >= 1, "maxEdges", maxEdges, "at least 1");
}

std::vector<vpTextureEdge> vpFindTextureEdges(const vpTrackedModel &model, const vpTextureEdgeOptions &options)
{
  options.check();
  std::vector<vpTextureEdge> edges;
  const double pixel = model.diameter() / options.resolution;
  for (const vpTextureChart &chart : vpMakeTextureCharts(model, options.minContrast)) {
    const vpChartImage image(model, chart, pixel);
    const vpEdgePixels pixels(image, weakest * options.minContrast);
    EdgeFitter fitter(image, pixels, chart.oriented, pixel, options, edges);
    for (const std::vector<int> &chain : pixels.chains()) {
      fitter.add(chain);
    }
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const vpTextureEdge &a, const vpTextureEdge &b) { return merit(a) > merit(b); });
  if (edges.size() > options.maxEdges) {
    edges.resize(options.maxEdges);
  }
  return edges;
}

END_VISP_NAMESPACE
