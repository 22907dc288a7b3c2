// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef renderModels_h
#define renderModels_h

#include <visp3/model/vpCpuRenderer.h>
#include <visp3/model/vpTrackedModelBuilder.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*!
  \file renderModels.h
  Models, poses and cameras that the tests of the renderers share.
*/

using ModelPointer = std::shared_ptr<const vpTrackedModel>;

constexpr double pi = 3.14159265358979323846;

inline ModelPointer build(const vpTrackedModelBuilder &builder)
{
  return std::make_shared<const vpTrackedModel>(builder.build("test model"));
}

//! A square of the plane z = 0 around the origin, seen from z < 0.
inline ModelPointer makeSquare(double side)
{
  const double h = side / 2.;
  vpTrackedModelBuilder builder;
  builder.addFace({{-h, -h, 0.}, {-h, h, 0.}, {h, h, 0.}, {h, -h, 0.}});
  return build(builder);
}

//! Faces of a prism over a polygon of the plane z = 0, counter-clockwise seen from z > 0.
inline void addPrism(vpTrackedModelBuilder &builder, const std::vector<Eigen::Vector2d> &base, double height)
{
  const auto at = [&](std::size_t i, double z) {
    const Eigen::Vector2d &p = base[i % base.size()];
    return Eigen::Vector3d(p.x(), p.y(), z);
  };
  std::vector<Eigen::Vector3d> top;
  std::vector<Eigen::Vector3d> bottom;
  for (std::size_t i = 0; i < base.size(); ++i) {
    top.push_back(at(i, height));
    bottom.insert(bottom.begin() + (i == 0 ? 0 : 1), at(i, 0.));
    builder.addFace({at(i, 0.), at(i + 1, 0.), at(i + 1, height), at(i, height)});
  }
  builder.addFace(top);
  builder.addFace(bottom);
}

inline ModelPointer makeBox(double x, double y, double z)
{
  vpTrackedModelBuilder builder;
  addPrism(builder, {{0., 0.}, {x, 0.}, {x, y}, {0., y}}, z);
  return build(builder);
}

inline ModelPointer makeLShape(double side, double thickness)
{
  vpTrackedModelBuilder builder;
  addPrism(builder, {{thickness, thickness}, {thickness, side}, {0., side}, {0., 0.}, {side, 0.}, {side, thickness}},
           thickness);
  return build(builder);
}

inline ModelPointer makeCylinder(double radius, double length)
{
  vpTrackedModelBuilder builder;
  builder.addCylinder(Eigen::Vector3d(0., 0., -length / 2.), Eigen::Vector3d(0., 0., length / 2.), radius);
  return build(builder);
}

inline vpTrackedModelBuilder::Corner makeCorner(double x, double y, double z)
{
  vpTrackedModelBuilder::Corner corner;
  corner.position = Eigen::Vector3d(x, y, z);
  return corner;
}

//! A sphere around the origin of about 4 rings^2 triangles.
inline ModelPointer makeSphere(double radius, int rings)
{
  const int sectors = 2 * rings;
  const auto at = [&](int ring, int sector) {
    const double polar = pi * ring / rings;
    const double s = (ring == 0 || ring == rings) ? 0. : radius * std::sin(polar);
    const double angle = 2. * pi * (sector % sectors) / sectors;
    return makeCorner(s * std::cos(angle), s * std::sin(angle), radius * std::cos(polar));
  };
  vpTrackedModelBuilder builder;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      if (i > 0) {
        builder.addTriangle({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
      }
      if (i + 1 < rings) {
        builder.addTriangle({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      }
    }
  }
  return build(builder);
}

inline vpCameraParameters makeCamera()
{
  return vpCameraParameters(600., 610., 321.3, 238.6);
}

//! Any rotation, in front of the camera of makeCamera() at \e distance, at times partly outside its 640 x 480 pixels.
inline vpHomogeneousMatrix randomPose(std::mt19937 &random, double distance)
{
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967295.);
  };
  const double x = uniform(-0.4, 0.4) * distance;
  const double y = uniform(-0.3, 0.3) * distance;
  const double z = uniform(0.8, 1.2) * distance;
  return vpHomogeneousMatrix(x, y, z, uniform(-pi, pi), uniform(-pi, pi), uniform(-pi, pi));
}

inline long coveredPixels(const vpRenderedView &view)
{
  return std::count_if(view.depth.begin(), view.depth.end(), [](float depth) { return depth > 0.F; });
}

//! Depth at the crop pixel nearest to an image point, 0 outside the crop.
inline double depthAt(const vpRenderedView &view, double u, double v)
{
  const int index = view.index(u, v);
  return index < 0 ? 0. : static_cast<double>(view.depth[static_cast<std::size_t>(index)]);
}

constexpr unsigned int imageWidth = 640;
constexpr unsigned int imageHeight = 480;

inline vpRenderedView renderOnCpu(const ModelPointer &model, const vpHomogeneousMatrix &cMo,
                                  const vpCameraParameters &cam, const vpRenderOptions &options = vpRenderOptions())
{
  vpRenderedView view;
  vpCpuRenderer(model).render(cMo, cam, imageWidth, imageHeight, options, view);
  return view;
}

inline vpRenderOptions allChannels(double scale = 1.)
{
  vpRenderOptions options;
  options.scale = scale;
  options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL | vpRenderOptions::FACE | vpRenderOptions::COLOR;
  return options;
}

//! Image point of the centre of crop pixel (row, column), as vpRenderedView documents it.
inline double imageColumn(const vpRenderedView &view, int column)
{
  return (view.left + column + 0.5) / view.scale - 0.5;
}
inline double imageRow(const vpRenderedView &view, int row)
{
  return (view.top + row + 0.5) / view.scale - 0.5;
}

#endif
