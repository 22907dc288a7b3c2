// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpControlPointMotion_h
#define vpControlPointMotion_h

#include <visp3/model/vpModelView.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

//! How far apart poses are, in pixels: the mean motion of a view's control points.
class vpControlPointMotion
{
public:
  //! Between the view's pose and \e cMo; infinite where a control point gets behind the camera.
  static double mean(const vpModelView &view, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
  {
    return average(
        view, [&](const vpControlPoint &point) -> Eigen::Vector2d { return project(point, cMo, cam) - point.pixel; });
  }

  //! Between two poses.
  static double between(const vpModelView &view, const vpHomogeneousMatrix &c1Mo, const vpHomogeneousMatrix &c2Mo,
                        const vpCameraParameters &cam)
  {
    return average(view, [&](const vpControlPoint &point) -> Eigen::Vector2d {
      return project(point, c1Mo, cam) - project(point, c2Mo, cam);
    });
  }

  //! Between two poses, less the motion of the middle of the object's box.
  static double aroundMiddle(const vpModelView &view, const vpHomogeneousMatrix &c1Mo, const vpHomogeneousMatrix &c2Mo,
                             const vpCameraParameters &cam)
  {
    vpControlPoint middle;
    middle.position = view.model().centre();
    const Eigen::Vector2d moved = project(middle, c1Mo, cam) - project(middle, c2Mo, cam);
    return average(view, [&](const vpControlPoint &point) -> Eigen::Vector2d {
      return project(point, c1Mo, cam) - project(point, c2Mo, cam) - moved;
    });
  }

private:
  template <typename Motion> static double average(const vpModelView &view, const Motion &motion)
  {
    double sum = 0.;
    for (const vpControlPoint &point : view.points()) {
      sum += motion(point).norm();
    }
    return view.points().empty() ? 0. : sum / static_cast<double>(view.points().size());
  }

  static Eigen::Vector2d project(const vpControlPoint &point, const vpHomogeneousMatrix &cMo,
                                 const vpCameraParameters &cam)
  {
    const Eigen::Vector3d &X = point.position;
    const double x = cMo[0][0] * X.x() + cMo[0][1] * X.y() + cMo[0][2] * X.z() + cMo[0][3];
    const double y = cMo[1][0] * X.x() + cMo[1][1] * X.y() + cMo[1][2] * X.z() + cMo[1][3];
    const double z = cMo[2][0] * X.x() + cMo[2][1] * X.y() + cMo[2][2] * X.z() + cMo[2][3];
    if (!(z > 0.)) {
      return Eigen::Vector2d::Constant(HUGE_VAL);
    }
    return {cam.get_px() * x / z + cam.get_u0(), cam.get_py() * y / z + cam.get_v0()};
  }
};

END_VISP_NAMESPACE
#endif
