// SPDX-License-Identifier: GPL-2.0-or-later
#include "point/vpSurfaceReader.h"
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Second differences of the inverse depth, as a share of it, that are steps or creases. At a focal length of 600
// pixels a crease between two faces at 45 degrees has 0.003, and a sphere of 100 pixels radius seen at its middle, a
// tenth of its distance large, 1e-5.
const float stepShare = 0.002F;
// Distance over which the slope is taken, pixels of the depth buffer.
const int slopeStep = 2;
// What is nearer by less than this share of the distance may be the same surface, drawn at another pixel.
const double hidingShare = 0.01;
} // namespace

bool vpSurfaceReader::isSmooth(int column, int row, int step) const
{
  if (column < step || row < step || column >= m_view.width - step || row >= m_view.height - step) {
    return false;
  }
  const float z = depth(column, row);
  const float left = depth(column - step, row);
  const float right = depth(column + step, row);
  const float up = depth(column, row - step);
  const float down = depth(column, row + step);
  if (!(z > 0.F && left > 0.F && right > 0.F && up > 0.F && down > 0.F)) {
    return false;
  }
  const float limit = stepShare * static_cast<float>(step);
  return std::fabs(z / left + z / right - 2.F) < limit && std::fabs(z / up + z / down - 2.F) < limit;
}

bool vpSurfaceReader::read(const vpPointCamera &camera, const Eigen::Vector2d &pixel, vpSurfaceElement &element) const
{
  const int index = m_view.index(pixel.x(), pixel.y());
  if (index < 0) {
    return false;
  }
  const int column = index % m_view.width;
  const int row = index / m_view.width;
  if (!isSmooth(column, row, slopeStep)) {
    return false;
  }
  const auto inverse = [this](int j, int i) { return 1. / static_cast<double>(depth(j, i)); };
  // Inverse depth's change per pixel of the image.
  const double across = m_view.scale / (2. * slopeStep);
  const double slopeU = across * (inverse(column + slopeStep, row) - inverse(column - slopeStep, row));
  const double slopeV = across * (inverse(column, row + slopeStep) - inverse(column, row - slopeStep));
  const double u = (m_view.left + column + 0.5) / m_view.scale - 0.5;
  const double v = (m_view.top + row + 0.5) / m_view.scale - 0.5;
  const double w = inverse(column, row) + slopeU * (pixel.x() - u) + slopeV * (pixel.y() - v);
  if (!(w > 0.)) {
    return false;
  }
  const Eigen::Vector2d p = camera.normalized(pixel);
  const Eigen::Vector3d ray(p.x(), p.y(), 1.);
  const Eigen::Matrix3d oRc = camera.cRo.transpose();
  element.position = camera.toObject(ray / w);
  element.across.col(0) = oRc * (Eigen::Vector3d(1. / camera.focal.x(), 0., 0.) - ray * (slopeU / w)) / w;
  element.across.col(1) = oRc * (Eigen::Vector3d(0., 1. / camera.focal.y(), 0.) - ray * (slopeV / w)) / w;
  // The plane is n . X = 1 with n . ray = w at every pixel: n points away from the camera.
  const Eigen::Vector2d slope(slopeU * camera.focal.x(), slopeV * camera.focal.y());
  element.normal = -(oRc * Eigen::Vector3d(slope.x(), slope.y(), w - slope.dot(p))).normalized();
  return true;
}

bool vpSurfaceReader::hides(const Eigen::Vector2d &pixel, double depthOfPoint) const
{
  const int index = m_view.index(pixel.x(), pixel.y());
  if (index < 0) {
    return false;
  }
  const int column = index % m_view.width;
  const int row = index / m_view.width;
  const double limit = (1. - hidingShare) * depthOfPoint;
  for (int i = std::max(row - 1, 0); i <= std::min(row + 1, m_view.height - 1); ++i) {
    for (int j = std::max(column - 1, 0); j <= std::min(column + 1, m_view.width - 1); ++j) {
      const float seen = depth(j, i);
      if (vpIsZero(seen) || static_cast<double>(seen) >= limit) {
        return false;
      }
    }
  }
  return true;
}

void vpSurfaceReader::markSmooth(const cv::Rect &area, cv::Mat &mask) const
{
  mask.create(area.size(), CV_8U);
  std::vector<int> columns;
  for (int j = 0; j < area.width; ++j) {
    columns.push_back(static_cast<int>(std::floor((area.x + j + 0.5) * m_view.scale)) - m_view.left);
  }
  for (int i = 0; i < area.height; ++i) {
    const int row = static_cast<int>(std::floor((area.y + i + 0.5) * m_view.scale)) - m_view.top;
    unsigned char *marks = mask.ptr<unsigned char>(i);
    for (int j = 0; j < area.width; ++j) {
      marks[j] = isSmooth(columns[static_cast<std::size_t>(j)], row, 1) ? 255 : 0;
    }
  }
}

END_VISP_NAMESPACE
