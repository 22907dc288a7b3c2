// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpContourScan.h"

#include "search/vpSameSide.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

BEGIN_VISP_NAMESPACE

namespace {
const double usualCellsPerRadius = 12.;
const double mostCells = 24.; // Of a radius, where the step is as large as it may be.
const double reachShare = 1. / 12.;
const double leastStep = 4.; // Pixels.
const double mostStep = 16.;
const double apart = 0.5;  // How far two places of one view are apart, radii.
const double beyond = 0.5; // How far outside the image the middle may be, radii.
const int fullMatch = 6;   // What a point on an edge counts: as much as bytes can hold of all points.
const std::size_t mostPoints = 40;
const unsigned int mostLevel = 3; // Of the sphere: views are made when first looked at, and all sides are looked at.
const float farAway = 16384.F;    // Pixels: an image of which no point of a view is outside.
} // namespace

void vpContourScan::setImage(const vpOrientedDistanceMap &edges, const vpCameraParameters &cam, unsigned int width,
                             unsigned int height, double radius)
{
  setImage(edges, cam, width, height, radius, usualCellsPerRadius, 0.);
}

void vpContourScan::setImage(const vpOrientedDistanceMap &edges, const vpCameraParameters &cam, unsigned int width,
                             unsigned int height, double radius, double cellsPerRadius, double clutter)
{
  m_camera = vpPointCamera(cam, width, height);
  m_clutter = clutter;
  m_radius = radius;
  m_step = std::min(std::max(radius / cellsPerRadius, leastStep), mostStep);
  m_reach = std::max(m_step, reachShare * radius);
  const double cells = std::min(radius / m_step, mostCells);
  m_margin = static_cast<int>(std::ceil(beyond * cells));
  m_border = static_cast<int>(std::ceil(cells)) + 1;
  m_columns = static_cast<int>(std::ceil(width / m_step)) + 2 * m_margin;
  m_rows = static_cast<int>(std::ceil(height / m_step)) + 2 * m_margin;
  m_stride = m_columns + 2 * m_border;
  m_gridSize = static_cast<std::size_t>(m_stride) * static_cast<std::size_t>(m_rows + 2 * m_border);
  m_grids.assign(m_gridSize * vpOrientedDistanceMap::bins * phases * phases, 0);
  m_sums.resize(static_cast<std::size_t>(m_stride) * static_cast<std::size_t>(m_rows));
  for (int phase = 0; phase < phases * phases; ++phase) {
    fill(edges, phase / phases, phase % phases);
  }
}

void vpContourScan::fill(const vpOrientedDistanceMap &edges, int rowPhase, int columnPhase)
{
  const double reach = std::min(m_reach, edges.settings().maxDistance);
  const int before = m_border + m_margin; // Cells before the image.
  for (int i = -1; i < m_rows - 2 * m_margin; ++i) {
    const double v = (i + static_cast<double>(rowPhase) / phases) * m_step;
    for (int j = -1; j < m_columns - 2 * m_margin; ++j) {
      const double u = (j + static_cast<double>(columnPhase) / phases) * m_step;
      const std::array<double, vpOrientedDistanceMap::bins> matches = matchesAt(edges, u, v, reach);
      for (int bin = 0; bin < vpOrientedDistanceMap::bins; ++bin) {
        m_grids[gridOf(bin, rowPhase, columnPhase) + static_cast<std::size_t>((i + before) * m_stride + j + before)] =
            static_cast<std::uint8_t>(fullMatch * matches[static_cast<std::size_t>(bin)] + 0.5);
      }
    }
  }
}

// Of edges of each orientation, less what those of all are worth.
std::array<double, vpOrientedDistanceMap::bins> vpContourScan::matchesAt(const vpOrientedDistanceMap &edges, double u,
                                                                         double v, double reach) const
{
  std::array<double, vpOrientedDistanceMap::bins> matches;
  double all = 0.;
  for (int bin = 0; bin < vpOrientedDistanceMap::bins; ++bin) {
    double &match = matches[static_cast<std::size_t>(bin)];
    match = std::max(1. - edges.distance(u, v, bin) / reach, 0.);
    all += match / vpOrientedDistanceMap::bins;
  }
  if (m_clutter > 0.) {
    for (double &match : matches) {
      match = std::max((match + m_clutter * (1. - all)) / (1. + m_clutter), 0.);
    }
  }
  return matches;
}

// To all places, what is where this point would be.
void vpContourScan::addPoint(const vpSeenPoint &point)
{
  const auto halfSteps = [this](float offset) { return static_cast<int>(std::floor(offset * phases / m_step + 0.5)); };
  const int row = halfSteps(point.v - farAway);
  const int column = halfSteps(point.u - farAway);
  const int rowPhase = row & (phases - 1);
  const int columnPhase = column & (phases - 1);
  const int i = (row - rowPhase) / phases;
  const int j = (column - columnPhase) / phases;
  if (std::abs(i) >= m_border || std::abs(j) >= m_border) {
    return; // Of a part that is much nearer to the camera than the middle is.
  }
  const int bin = vpOrientedDistanceMap::bin(point.normalU, point.normalV);
  const std::uint8_t *from =
      m_grids.data() + gridOf(bin, rowPhase, columnPhase) + (m_border + i) * m_stride + m_border + j;
  std::uint8_t *sums = m_sums.data();
  const std::size_t size = m_sums.size() - static_cast<std::size_t>(2 * m_border);
  for (std::size_t k = 0; k < size; ++k) {
    sums[k] = static_cast<std::uint8_t>(sums[k] + from[k]);
  }
}

vpContourScan::Find vpContourScan::largestSum(std::size_t points) const
{
  std::uint8_t most = 0;
  for (const std::uint8_t sum : m_sums) {
    most = std::max(most, sum);
  }
  const auto place = static_cast<int>(std::find(m_sums.begin(), m_sums.end(), most) - m_sums.begin());
  const auto pixels = [this](int cell) { return static_cast<float>((cell - m_margin) * m_step); };
  return {pixels(place % m_stride), pixels(place / m_stride),
          static_cast<double>(most) / static_cast<double>(fullMatch * points)};
}

// So that the next one is apart.
void vpContourScan::blankAround(const Find &find)
{
  const auto cell = [this](float pixels) { return static_cast<int>(std::lround(pixels / m_step)) + m_margin; };
  const int half = std::max(1, static_cast<int>(apart * m_radius / m_step));
  const int column = cell(find.u);
  const int left = std::max(column - half, 0);
  const int right = std::min(column + half + 1, m_columns);
  const int bottom = std::min(cell(find.v) + half + 1, m_rows);
  for (int i = std::max(cell(find.v) - half, 0); i < bottom; ++i) {
    std::fill(m_sums.begin() + i * m_stride + left, m_sums.begin() + i * m_stride + right, std::uint8_t{0});
  }
}

std::size_t vpContourScan::addPoints(const Eigen::Isometry3d &cMo)
{
  const Eigen::Vector3d middle = m_sphere->model().centre();
  const Eigen::Vector3d at = cMo * middle;
  if (!(at.z() > 0.)) {
    return 0;
  }
  const unsigned int level = std::min(m_level, mostLevel);
  const vpSphereView &view = m_sphere->view(m_sphere->nearest(cMo.linear().transpose() * -at, level));
  vpPointCamera camera = m_camera;
  camera.u0 = camera.v0 = farAway;
  camera.width = camera.height = 2.F * farAway;
  std::fill(m_sums.begin(), m_sums.end(), std::uint8_t{0});
  const std::size_t every = (view.size() + mostPoints - 1) / mostPoints;
  std::size_t points = 0;
  vpPointProjection(vpSameSide(cMo, middle, {0., 0., at.z()}), camera)
      .forEachSeen(view, view.size(), [&](const vpSeenPoint &point) {
        if (point.number % every == 0) {
          ++points;
          addPoint(point);
        }
      });
  for (int i = 0; i < m_rows; ++i) { // Behind a row's last place, the sums mix both sides of the image.
    std::fill_n(m_sums.begin() + i * m_stride + m_columns, m_stride - m_columns, std::uint8_t{0});
  }
  return points;
}

vpContourScan::Find vpContourScan::find(const Eigen::Isometry3d &cMo)
{
  const std::size_t points = addPoints(cMo);
  return points == 0 ? Find() : largestSum(points);
}

void vpContourScan::find(const Eigen::Isometry3d &cMo, std::size_t most, std::vector<Find> &finds)
{
  const std::size_t points = addPoints(cMo);
  for (std::size_t i = 0; i < most && points > 0; ++i) {
    finds.push_back(largestSum(points));
    blankAround(finds.back());
  }
}

Eigen::Isometry3d vpContourScan::movedTo(const Find &find, const Eigen::Isometry3d &cMo) const
{
  const Eigen::Vector3d middle = m_sphere->model().centre();
  const double depth = (cMo * middle).z();
  return vpSameSide(cMo, middle,
                    {depth * static_cast<double>((find.u - m_camera.u0) / m_camera.px),
                     depth * static_cast<double>((find.v - m_camera.v0) / m_camera.py), depth});
}

END_VISP_NAMESPACE
