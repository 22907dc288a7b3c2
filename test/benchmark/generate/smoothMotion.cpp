// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/smoothMotion.h"

#include <visp3/se3/vpPoseRandom.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {
const double turn = 2. * M_PI;
const double degree = M_PI / 180.;
const int leadIn = 3;

Eigen::Matrix3d turnAbout(const Eigen::Vector3d &axis, double angle)
{
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}
} // namespace

double SmoothMotion::Wave::at(double parameter) const
{
  return std::sin(turn * frequency * parameter + phase);
}

SmoothMotion::SmoothMotion(const SceneCamera &camera, const MotionSettings &settings)
    : m_camera(camera), m_settings(settings), m_extent(settings.points)
{
  // An object that leaves the image is to do so by moving, with little time for turning.
  const double slow = settings.exits ? 0.2 : 1.;
  vpPoseRandom random(settings.seed, {0x6d6f74696f6e});
  const auto wave = [&](double frequency) {
    return Wave{frequency * (0.9 + 0.2 * random.uniform()), turn * random.uniform()};
  };
  m_yaw = wave(0.83 * slow);
  m_pitch = wave(0.41 * slow);
  m_roll = wave(0.29 * slow);
  m_column = wave(0.47 * slow);
  m_row = wave(0.37 * slow);
  m_size = wave(0.31 * slow);
  m_speed = wave(1. / 67.);
  m_speed2 = wave(1. / 29.);
  m_firstYaw = turn * random.uniform();
  chooseParameters();
}

Eigen::Matrix3d SmoothMotion::rotationAt(double parameter) const
{
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  // The object's y axis is up, and its z axis towards the camera, where all angles are zero.
  const Eigen::Matrix3d upright = turnAbout(x, M_PI);
  if (m_settings.frontOnly) {
    const double yaw = 50. * degree * m_yaw.at(parameter);
    const double pitch = 32. * degree * m_pitch.at(parameter);
    return turnAbout(z, 25. * degree * m_roll.at(parameter)) * turnAbout(x, pitch) * turnAbout(y, yaw) * upright;
  }
  const double turns = m_settings.exits ? 0.2 : 1.;
  const double yaw = m_firstYaw + turn * turns * parameter + 0.4 * m_yaw.at(parameter);
  const double pitch = 65. * degree * m_pitch.at(parameter);
  return turnAbout(z, 40. * degree * m_roll.at(parameter)) * turnAbout(x, pitch) * turnAbout(y, yaw) * upright;
}

Eigen::Vector2d SmoothMotion::placeAt(double parameter, double distance) const
{
  const double focal = m_camera.cam.get_px();
  const double extent = focal * m_extent.radius / (distance - m_extent.radius) + m_settings.margin * m_camera.scale();
  const double column = std::max(0., m_camera.width / 2. - extent) * m_column.at(parameter);
  if (!m_settings.exits) {
    return {column, std::max(0., m_camera.height / 2. - extent) * m_row.at(parameter)};
  }
  // Up and down through the image, beyond its upper and lower edge in turn.
  const int before = static_cast<int>(std::floor(parameter - 0.5));
  const double between = parameter - 0.5 - before;
  const double blend = between * between * (3. - 2. * between);
  const double reach = (1. - blend) * reachOf(before) + blend * reachOf(before + 1);
  return {0.6 * column, reach * std::sin(M_PI * parameter)};
}

double SmoothMotion::reachOf(int crossing) const
{
  const double parameter = crossing + 0.5;
  const double focal = m_camera.cam.get_px();
  const double distance = distanceAt(parameter);
  const double side = crossing % 2 == 0 ? 1. : -1.;
  const Eigen::Matrix3d rotation = rotationAt(parameter);
  // Distance of the centre from the image's middle at which no point is in the image any more.
  double outside = 0.;
  for (const Eigen::Vector3d &p : m_extent.points) {
    const Eigen::Vector3d c = rotation * (p - m_extent.centre);
    const double edge = m_camera.height / 2. * (distance + c.z());
    outside = std::max(outside, (edge - focal * side * c.y()) / distance);
  }
  return outside + 48. * m_camera.scale();
}

double SmoothMotion::distanceAt(double parameter) const
{
  const double size = m_settings.pixelDiameter * m_camera.scale() * (1. + 0.15 * m_size.at(parameter));
  return m_camera.cam.get_px() * m_extent.diameter / size;
}

vpHomogeneousMatrix SmoothMotion::poseAt(double parameter) const
{
  const Eigen::Matrix3d rotation = rotationAt(parameter);
  const double focal = m_camera.cam.get_px();
  const double distance = distanceAt(parameter);
  const Eigen::Vector2d place = placeAt(parameter, distance);
  const Eigen::Vector3d centre(place.x() * distance / focal, place.y() * distance / focal, distance);
  return poseAround(m_extent.centre, rotation, centre);
}

void SmoothMotion::project(const vpHomogeneousMatrix &cMo, std::vector<Eigen::Vector2d> &pixels) const
{
  pixels.resize(m_extent.points.size());
  for (std::size_t i = 0; i < m_extent.points.size(); ++i) {
    Eigen::Vector3d c;
    for (unsigned int k = 0; k < 3; ++k) {
      c(k) = cMo[k][0] * m_extent.points[i].x() + cMo[k][1] * m_extent.points[i].y() +
             cMo[k][2] * m_extent.points[i].z() + cMo[k][3];
    }
    pixels[i] << m_camera.cam.get_px() * c.x() / c.z(), m_camera.cam.get_py() * c.y() / c.z();
  }
}

double SmoothMotion::nextParameter(double parameter, double pixels) const
{
  std::vector<Eigen::Vector2d> from;
  std::vector<Eigen::Vector2d> to;
  project(poseAt(parameter), from);
  const auto distance = [&](double step) {
    project(poseAt(parameter + step), to);
    double sum = 0.;
    for (std::size_t i = 0; i < from.size(); ++i) {
      sum += (to[i] - from[i]).norm();
    }
    return sum / static_cast<double>(from.size());
  };
  double low = 0.;
  double high = 1e-3;
  while (distance(high) < pixels && high < 1.) {
    low = high;
    high *= 1.5;
  }
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (distance(middle) < pixels ? low : high) = middle;
  }
  return parameter + 0.5 * (low + high);
}

void SmoothMotion::chooseParameters()
{
  // An exit starts with the object in the middle of the image, half a crossing before it is outside.
  double parameter = 0.;
  for (int k = -leadIn; k <= m_settings.frames + 2; ++k) {
    m_parameters.push_back(parameter);
    const double wobble = 0.75 * m_speed.at(k) + 0.25 * m_speed2.at(k);
    const double pixels = m_settings.exits ? 7.1 + 0.5 * wobble : 6. + 1.7 * wobble;
    parameter = nextParameter(parameter, m_settings.scale * pixels * m_camera.scale());
  }
}

vpHomogeneousMatrix SmoothMotion::pose(double time) const
{
  // Catmull and Rom's spline, which goes through the parameters of the frames.
  const double inside = std::clamp(time, -1., static_cast<double>(m_settings.frames));
  const int k = static_cast<int>(std::floor(inside));
  const double x = inside - k;
  const double *p = &m_parameters[static_cast<std::size_t>(k + leadIn - 1)];
  const double parameter =
      p[1] +
      0.5 * x * (p[2] - p[0] + x * (2. * p[0] - 5. * p[1] + 4. * p[2] - p[3] + x * (3. * (p[1] - p[2]) + p[3] - p[0])));
  return poseAt(parameter);
}

} // namespace bench
