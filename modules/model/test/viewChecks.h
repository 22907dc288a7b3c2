// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef viewChecks_h
#define viewChecks_h

#include <visp3/model/vpCpuRenderer.h>
#include <visp3/model/vpModelView.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

/*! \file viewChecks.h Poses, projection and ray casts that know nothing of the code under test. */

BEGIN_VISP_NAMESPACE
namespace viewChecks {
using Point = Eigen::Vector3d;
using Pixel = Eigen::Vector2d;

//! The camera looks at \e target from a distance in a direction, both in the object frame, turned by \e roll radians.
inline vpHomogeneousMatrix lookFrom(const Point &direction, double distance, double roll = 0.,
                                    const Point &target = Point::Zero())
{
  Eigen::Matrix3d axes; // Of the camera, as rows.
  axes.row(2) = -direction.normalized();
  axes.row(0) = axes.row(2).unitOrthogonal();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  axes = Eigen::AngleAxisd(roll, Point::UnitZ()).toRotationMatrix() * axes;
  const Point translation = Point(0., 0., distance) - axes * target;
  vpHomogeneousMatrix cMo;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      cMo[i][j] = axes(i, j);
    }
    cMo[i][3] = translation(i);
  }
  return cMo;
}

//! A model, a camera of 640 x 480 pixels, and the view of the one from the other.
class Looker
{
public:
  explicit Looker(vpTrackedModel model)
      : m_model(std::make_shared<const vpTrackedModel>(std::move(model))), m_renderer(m_model), m_view(m_model)
  {
  }

  const vpModelView &look(const vpHomogeneousMatrix &cMo)
  {
    m_cMo = cMo;
    m_view.compute(cMo, cam, width, height, options, &m_renderer);
    return m_view;
  }

  const vpTrackedModel &model() const { return *m_model; }
  const vpModelView &view() const { return m_view; }
  const std::vector<vpControlPoint> &points() const { return m_view.points(); }

  Point toCamera(const Point &oX) const
  {
    Point cX;
    for (unsigned int i = 0; i < 3; ++i) {
      cX(i) = m_cMo[i][0] * oX.x() + m_cMo[i][1] * oX.y() + m_cMo[i][2] * oX.z() + m_cMo[i][3];
    }
    return cX;
  }
  Pixel project(const Point &oX) const
  {
    const Point cX = toCamera(oX);
    return Pixel(cam.get_u0() + cam.get_px() * cX.x() / cX.z(), cam.get_v0() + cam.get_py() * cX.y() / cX.z());
  }
  //! Centre of the camera, object frame.
  Point centre() const
  {
    const vpHomogeneousMatrix oMc = m_cMo.inverse();
    return Point(oMc[0][3], oMc[1][3], oMc[2][3]);
  }
  //! Line of sight of a pixel, object frame, of depth 1 m.
  Point sight(const Pixel &pixel) const
  {
    const Point c((pixel.x() - cam.get_u0()) / cam.get_px(), (pixel.y() - cam.get_v0()) / cam.get_py(), 1.);
    Point o = Point::Zero();
    for (unsigned int i = 0; i < 3; ++i) {
      o += c(i) * Point(m_cMo[i][0], m_cMo[i][1], m_cMo[i][2]);
    }
    return o;
  }
  //! Depth of the first surface on the line of sight of a pixel, metres; infinity where there is none.
  double castRay(const Pixel &pixel) const;
  //! Tangent of a control point's edge in the image by finite differences, along its direction, not of unit length.
  Pixel tangent(const vpControlPoint &point) const
  {
    const Point step = 1e-6 * point.direction;
    return project(point.position + step) - project(point.position - step);
  }

  vpCameraParameters cam = vpCameraParameters(600., 610., 321.3, 238.6);
  unsigned int width = 640;
  unsigned int height = 480;
  vpModelViewOptions options;

private:
  std::shared_ptr<const vpTrackedModel> m_model;
  vpCpuRenderer m_renderer;
  vpModelView m_view;
  vpHomogeneousMatrix m_cMo;
};

inline double Looker::castRay(const Pixel &pixel) const
{
  const Point origin = centre();
  const Point ray = sight(pixel);
  double nearest = std::numeric_limits<double>::infinity();
  for (const vpModelTriangle &triangle : m_model->triangles()) {
    const Point &a = m_model->vertices()[static_cast<std::size_t>(triangle.vertex[0])];
    const Point e1 = m_model->vertices()[static_cast<std::size_t>(triangle.vertex[1])] - a;
    const Point e2 = m_model->vertices()[static_cast<std::size_t>(triangle.vertex[2])] - a;
    const Point cross = ray.cross(e2);
    const double determinant = e1.dot(cross);
    const Point from = origin - a;
    const double u = from.dot(cross) / determinant;
    const double v = ray.dot(from.cross(e1)) / determinant;
    const double depth = e2.dot(from.cross(e1)) / determinant;
    if (u >= 0. && v >= 0. && u + v <= 1. && depth > 0.) {
      nearest = std::min(nearest, depth);
    }
  }
  return nearest;
}

//! The pixel and eight more around it.
inline std::vector<Pixel> around(const Pixel &pixel, double radius)
{
  std::vector<Pixel> pixels = {pixel};
  for (int i = 0; i < 8; ++i) {
    pixels.emplace_back(pixel + radius * Pixel(std::cos(i * M_PI / 4.), std::sin(i * M_PI / 4.)));
  }
  return pixels;
}

//! Something is in front of all pixels within a radius, nearer than the point by more than \e gap metres.
inline bool isWellHidden(const Looker &looker, const Point &oX, double radius, double gap)
{
  const double limit = looker.toCamera(oX).z() - gap;
  const std::vector<Pixel> pixels = around(looker.project(oX), radius);
  return std::all_of(pixels.begin(), pixels.end(), [&](const Pixel &pixel) { return looker.castRay(pixel) < limit; });
}

//! Largest distance in pixels between where control points say that they are seen and the projection of their place.
inline double projectionError(const Looker &looker)
{
  double worst = 0.;
  for (const vpControlPoint &point : looker.points()) {
    worst = std::max(worst, (point.pixel - looker.project(point.position)).norm());
  }
  return worst;
}

//! Largest difference of a normal from the tangent turned by a right angle from u towards v, times side.
inline double normalError(const Looker &looker)
{
  double worst = 0.;
  for (const vpControlPoint &point : looker.points()) {
    const Pixel tangent = looker.tangent(point).normalized();
    worst = std::max(worst, (point.normal - point.side * Pixel(-tangent.y(), tangent.x())).norm());
  }
  return worst;
}

//! True where the contours take all control points in order, and each point knows its contour.
inline bool contoursHoldAllPoints(const vpModelView &view)
{
  int next = 0;
  for (std::size_t c = 0; c < view.contours().size(); ++c) {
    const vpContour &contour = view.contours()[c];
    if (contour.first != next || contour.count < 1) {
      return false;
    }
    for (; next < contour.first + contour.count; ++next) {
      if (view.points()[static_cast<std::size_t>(next)].contour != static_cast<int>(c)) {
        return false;
      }
    }
  }
  return next == static_cast<int>(view.points().size());
}

//! Largest difference of arc lengths from (i + 1/2) steps, in pixels, for the points i of each contour.
inline double arcLengthError(const vpModelView &view)
{
  double worst = 0.;
  for (const vpContour &contour : view.contours()) {
    for (int i = 0; i < contour.count; ++i) {
      const vpControlPoint &point = view.points()[static_cast<std::size_t>(contour.first + i)];
      worst = std::max(worst, std::fabs(point.arcLength - (i + 0.5) * contour.step));
    }
  }
  return worst;
}

//! Distance of the nearest control point for which \e counts is true, pixels.
template <class Filter> double nearestPoint(const vpModelView &view, const Pixel &pixel, Filter counts)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const vpControlPoint &point : view.points()) {
    if (counts(point)) {
      nearest = std::min(nearest, (point.pixel - pixel).norm());
    }
  }
  return nearest;
}

inline double nearestPoint(const vpModelView &view, const Pixel &pixel)
{
  return nearestPoint(view, pixel, [](const vpControlPoint &) { return true; });
}
} // namespace viewChecks
END_VISP_NAMESPACE
#endif
