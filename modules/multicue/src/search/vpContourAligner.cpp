// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpContourAligner.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const int places = 7;                                   // Of the image on each side of a silhouette point.
const int fullSteps = 2 * vpColorOddsMap::stepsPerUnit; // Colours that separate better than this are no surer.
const float leastGain = 1.F;                            // A contour that explains its line no better is none.
const float fullGain = 4.F;                             // One that does it better than this is no surer.
// How far a pose may move in one step, deviations.
const double motion = 0.1; // Diameters.
const double turn = 0.25;  // Radians.
const std::size_t fewestPoints = 6;
// Where a distance map's slope is looked at, and the weight of an edge that runs across, pixels.
const float slopeReach = 2.F;
const float leastSlope = 0.1F;
const double edgeDeviation = 4.; // Of an edge's place: the nearest one is often another one, pixels.
} // namespace

/*
  The upper left of the sums is J^T W J, and its seventh column J^T W e: a row holds the six derivatives of a point's
  offset and the offset. Eight columns make each row two vector instructions.
*/
struct vpContourAligner::Equations
{
  float sums[6][8] = {};
  std::size_t points = 0;

  void add(const std::array<float, 8> &row, float weight)
  {
    for (std::size_t i = 0; i < 6; ++i) {
      const float factor = weight * row[i];
      for (std::size_t j = 0; j < 8; ++j) {
        sums[i][j] += factor * row[j];
      }
    }
  }

  // What solves them, with deviations of both parts of the motion expected beforehand in units of a point's.
  Eigen::Matrix<double, 6, 1> solve(double translation, double rotation) const
  {
    Eigen::Matrix<double, 6, 6> normal;
    Eigen::Matrix<double, 6, 1> right;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        normal(i, j) = static_cast<double>(sums[i][j]);
      }
      normal(i, i) += 1. / (i < 3 ? translation * translation : rotation * rotation);
      right(i) = static_cast<double>(sums[i][6]);
    }
    return normal.ldlt().solve(right);
  }
};

void vpContourAligner::setImage(const vpColorOddsMap *colors, const vpOrientedDistanceMap *edges,
                                const vpCameraParameters &cam, unsigned int width, unsigned int height)
{
  m_colors = colors;
  m_edges = edges;
  m_camera = vpPointCamera(cam, width, height);
}

// With sums S_k from the inside outwards, the contour's place k has all before it inside: 2 S_k - S is largest there.
// Without a contour, all of the line is inside or all of it outside, which is worth |S|.
vpContourAligner::Contour vpContourAligner::findByColors(const vpSeenPoint &point, float spacing) const
{
  const float du = spacing * point.normalU / point.length;
  const float dv = spacing * point.normalV / point.length;
  std::array<int, 2 * places + 1> odds;
  m_colors->lookUpLine(point.u - places * du, point.v - places * dv, du, dv, odds);
  int sum = 0;
  int largest = -fullSteps - 1;
  int best = 0;
  for (int k = 0; k <= 2 * places; ++k) {
    sum += std::min(std::max(odds[static_cast<std::size_t>(k)], -fullSteps), fullSteps);
    best = sum > largest ? k : best;
    largest = std::max(largest, sum);
  }
  const float gain = static_cast<float>(2 * largest - sum - std::abs(sum)) * (1.F / vpColorOddsMap::stepsPerUnit);
  const float offset = (static_cast<float>(best - places) + 0.5F) * spacing;
  return {gain < leastGain ? 0.F : std::min(gain, fullGain) / (1.F + std::fabs(offset) / (3.F * spacing)), offset};
}

vpContourAligner::Contour vpContourAligner::findByEdges(const vpSeenPoint &point) const
{
  const int bin = vpOrientedDistanceMap::bin(point.normalU, point.normalV);
  const auto distance = [&](float offset) {
    const float u = point.u + offset * point.normalU / point.length;
    const float v = point.v + offset * point.normalV / point.length;
    return static_cast<float>(m_edges->distance(u, v, bin));
  };
  const float here = distance(0.F);
  const float inside = distance(-slopeReach);
  const float outside = distance(slopeReach);
  const float share = here / static_cast<float>(m_edges->settings().maxDistance);
  const float slope = (inside - outside) / (2.F * slopeReach); // 1 where the edge is straight outwards.
  return {std::max(1.F - share * share, 0.F) * std::min(std::fabs(slope) + leastSlope, 1.F),
          slope < 0.F ? -here : here};
}

void vpContourAligner::addContour(const vpSeenPoint &point, const Eigen::Vector3f &centre, const Contour &contour,
                                  Equations &equations) const
{
  ++equations.points;
  if (!(contour.weight > 0.F)) {
    return;
  }
  const float scale = 1.F / point.length;
  // How the point's image moves along the normal with the point, and so with the pose about the object's centre.
  const float inverse = 1.F / point.z;
  const float gx = m_camera.px * point.normalU * scale * inverse;
  const float gy = m_camera.py * point.normalV * scale * inverse;
  const float gz = -(gx * point.x + gy * point.y) * inverse;
  const float x = point.x - centre.x();
  const float y = point.y - centre.y();
  const float z = point.z - centre.z();
  equations.add({{gx, gy, gz, y * gz - z * gy, z * gx - x * gz, x * gy - y * gx, contour.offset, 0.F}}, contour.weight);
}

const vpSphereView &vpContourAligner::viewAt(const Eigen::Isometry3d &cMo) const
{
  return m_sphere->view(m_sphere->nearest(cMo.linear().transpose() * -(cMo * m_sphere->model().centre()), m_level));
}

bool vpContourAligner::stepByColors(Eigen::Isometry3d &cMo, double reach, std::size_t every) const
{
  const double depth = (cMo * m_sphere->model().centre()).z();
  if (!(depth > 0.)) {
    return false;
  }
  const vpSphereView &view = viewAt(cMo);
  const double spacing = reach * static_cast<double>(m_camera.px) * m_sphere->model().diameter() / depth / places;
  // A contour's place is known to about the distance of the places that were looked at.
  return step(cMo, view, {view.silhouettes(), every}, spacing,
              [this, spacing](const vpSeenPoint &point) { return findByColors(point, static_cast<float>(spacing)); });
}

bool vpContourAligner::stepByEdges(Eigen::Isometry3d &cMo) const
{
  if (!((cMo * m_sphere->model().centre()).z() > 0.)) {
    return false;
  }
  const vpSphereView &view = viewAt(cMo);
  return step(cMo, view, {view.size(), 1}, edgeDeviation,
              [this](const vpSeenPoint &point) { return findByEdges(point); });
}

// \param unit Deviation of a contour's place, pixels.
template <typename Finder>
bool vpContourAligner::step(Eigen::Isometry3d &cMo, const vpSphereView &view, const Points &points, double unit,
                            Finder &&find) const
{
  const vpTrackedModel &model = m_sphere->model();
  const Eigen::Vector3d middle = model.centre();
  const Eigen::Vector3d centre = cMo * middle;
  vpPointProjection projection(cMo, m_camera);
  Equations equations;
  projection.forEachSeen(view, points.count, [&](const vpSeenPoint &point) {
    if (point.length > 0.F && point.number % points.every == 0) {
      addContour(point, centre.cast<float>(), find(point), equations);
    }
  });
  if (equations.points < fewestPoints) {
    return false;
  }
  const double scale = std::sqrt(static_cast<double>(points.every)) / unit; // As if all of them took part.
  const Eigen::Matrix<double, 6, 1> moved = equations.solve(motion * model.diameter() * scale, turn * scale);
  const double angle = moved.tail<3>().norm();
  Eigen::Matrix3d rotation = cMo.linear();
  if (angle > 0.) {
    rotation = Eigen::AngleAxisd(angle, moved.tail<3>() / angle).toRotationMatrix() * cMo.linear();
  }
  const Eigen::Vector3d movedCentre = centre + moved.head<3>();
  if (!moved.allFinite() || !(movedCentre.z() > 0.)) {
    return false;
  }
  cMo.linear() = rotation;
  cMo.translation() = movedCentre - rotation * middle;
  return true;
}

END_VISP_NAMESPACE
