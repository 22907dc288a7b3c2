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

void vpContourAligner::setImage(const vpColorOddsMap &colors, const vpCameraParameters &cam, unsigned int width,
                                unsigned int height)
{
  m_colors = &colors;
  m_camera = vpPointCamera(cam, width, height);
}

// With sums S_k from the inside outwards, the contour's place k has all before it inside: 2 S_k - S is largest there.
// Without a contour, all of the line is inside or all of it outside, which is worth |S|.
vpContourAligner::Contour vpContourAligner::findContour(float u, float v, float du, float dv, float spacing) const
{
  std::array<int, 2 * places + 1> odds;
  m_colors->lookUpLine(u - places * du, v - places * dv, du, dv, odds);
  int sum = 0;
  int largest = -fullSteps - 1;
  int best = 0;
  for (int k = 0; k <= 2 * places; ++k) {
    sum += std::min(std::max(odds[static_cast<std::size_t>(k)], -fullSteps), fullSteps);
    best = sum > largest ? k : best;
    largest = std::max(largest, sum);
  }
  const int gain = 2 * largest - sum - std::abs(sum);
  return {static_cast<float>(gain) * (1.F / vpColorOddsMap::stepsPerUnit),
          (static_cast<float>(best - places) + 0.5F) * spacing};
}

void vpContourAligner::addPoint(const vpSeenPoint &point, const Eigen::Vector3f &centre, float spacing,
                                Equations &equations) const
{
  if (!(point.length > 0.F)) {
    return;
  }
  ++equations.points;
  const float scale = 1.F / point.length;
  const float normalU = point.normalU * scale;
  const float normalV = point.normalV * scale;
  const Contour contour = findContour(point.u, point.v, spacing * normalU, spacing * normalV, spacing);
  if (contour.gain < leastGain) {
    return;
  }
  // How the point's image moves along the normal with the point, and so with the pose about the object's centre.
  const float inverse = 1.F / point.z;
  const float gx = m_camera.px * normalU * inverse;
  const float gy = m_camera.py * normalV * inverse;
  const float gz = -(gx * point.x + gy * point.y) * inverse;
  const float x = point.x - centre.x();
  const float y = point.y - centre.y();
  const float z = point.z - centre.z();
  const float weight = std::min(contour.gain, fullGain) / (1.F + std::fabs(contour.offset) / (3.F * spacing));
  equations.add({{gx, gy, gz, y * gz - z * gy, z * gx - x * gz, x * gy - y * gx, contour.offset, 0.F}}, weight);
}

bool vpContourAligner::step(Eigen::Isometry3d &cMo, double reach) const
{
  const vpTrackedModel &model = m_sphere->model();
  const Eigen::Vector3d middle = model.centre();
  const Eigen::Vector3d centre = cMo * middle;
  if (!(centre.z() > 0.)) {
    return false;
  }
  const vpSphereView &view = m_sphere->view(m_sphere->nearest(cMo.linear().transpose() * -centre));
  const float spacing = static_cast<float>(reach * m_camera.px * model.diameter() / centre.z() / places);
  vpPointProjection::Pose pose;
  Eigen::Map<Eigen::Matrix<float, 3, 4, Eigen::RowMajor>>(pose.data()) = cMo.matrix().topRows<3>().cast<float>();
  vpPointProjection projection(pose, m_camera);
  Equations equations;
  projection.forEachSeen(view, view.silhouettes(),
                         [&](const vpSeenPoint &point) { addPoint(point, centre.cast<float>(), spacing, equations); });
  if (equations.points < fewestPoints) {
    return false;
  }
  // A contour's place is known to about the distance of the places that were looked at.
  const Eigen::Matrix<double, 6, 1> moved = equations.solve(motion * model.diameter() / spacing, turn / spacing);
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
