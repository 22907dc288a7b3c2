// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointProjection_h
#define vpPointProjection_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/model/vpSphereView.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>

BEGIN_VISP_NAMESPACE

// A point of a precomputed view at a pose.
struct vpSeenPoint
{
  std::size_t number;     // Of the point.
  float x, y, z;          // Camera frame, metres.
  float u, v;             // Pixels.
  float normalU, normalV; // Outward normal of the contour, of this length:
  float length;
};

// The image that points are projected into.
struct vpPointCamera
{
  vpPointCamera() = default;
  vpPointCamera(const vpCameraParameters &cam, unsigned int columns, unsigned int rows)
      : px(static_cast<float>(cam.get_px())), py(static_cast<float>(cam.get_py())),
        u0(static_cast<float>(cam.get_u0())), v0(static_cast<float>(cam.get_v0())), width(static_cast<float>(columns)),
        height(static_cast<float>(rows))
  {
  }

  float px = 0.F, py = 0.F, u0 = 0.F, v0 = 0.F;
  float width = 0.F, height = 0.F;
};

/*
  The points of a view at one pose. A block of them at a time, so that nothing is allocated: first all numbers, in a
  loop that compilers turn into vector instructions, then those of the points that are in the image.
*/
class vpPointProjection
{
public:
  // Rows of the pose's upper three, one after the other.
  using Pose = std::array<float, 12>;

  vpPointProjection(const Pose &pose, const vpPointCamera &camera) : m_pose(pose), m_camera(camera) {}
  vpPointProjection(const Eigen::Isometry3d &cMo, const vpPointCamera &camera) : m_camera(camera)
  {
    Eigen::Map<Eigen::Matrix<float, 3, 4, Eigen::RowMajor>>(m_pose.data()) = cMo.matrix().topRows<3>().cast<float>();
  }

  // Calls visit(vpSeenPoint) for those of the first count points that are in the image.
  template <typename Visitor> void forEachSeen(const vpSphereView &view, std::size_t count, Visitor &&visit)
  {
    for (std::size_t first = 0; first < count; first += most) {
      const std::size_t end = std::min(most, count - first);
      project(view, first, end);
      for (std::size_t i = 0; i < end; ++i) {
        const bool isInside =
            m_z[i] > 0.F && m_u[i] >= 0.F && m_v[i] >= 0.F && m_u[i] < m_camera.width && m_v[i] < m_camera.height;
        if (isInside) {
          visit(
              vpSeenPoint{first + i, m_x[i], m_y[i], m_z[i], m_u[i], m_v[i], m_normalU[i], m_normalV[i], m_length[i]});
        }
      }
    }
  }

private:
  static constexpr std::size_t most = 128; // Points of a block.

  void project(const vpSphereView &view, std::size_t first, std::size_t count);

  Pose m_pose;
  vpPointCamera m_camera;
  std::array<float, most> m_x, m_y, m_z, m_u, m_v, m_normalU, m_normalV, m_length;
};

END_VISP_NAMESPACE
#endif
