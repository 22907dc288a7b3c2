// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpCpuRenderer.h>

#include "renderModels.h"

#include <catchMain.h>

#include <limits>

namespace {
Eigen::Vector2d project(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, const Eigen::Vector3d &point)
{
  Eigen::Vector3d p;
  for (unsigned int i = 0; i < 3; ++i) {
    p[static_cast<int>(i)] = cMo[i][0] * point.x() + cMo[i][1] * point.y() + cMo[i][2] * point.z() + cMo[i][3];
  }
  return Eigen::Vector2d(cam.get_u0() + cam.get_px() * p.x() / p.z(), cam.get_v0() + cam.get_py() * p.y() / p.z());
}

//! Depth of the object's plane z = 0 on the line of sight of image point (u, v).
double planeDepth(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, double u, double v)
{
  const Eigen::Vector3d normal(cMo[0][2], cMo[1][2], cMo[2][2]);
  const Eigen::Vector3d origin(cMo[0][3], cMo[1][3], cMo[2][3]);
  const Eigen::Vector3d ray((u - cam.get_u0()) / cam.get_px(), (v - cam.get_v0()) / cam.get_py(), 1.);
  return normal.dot(origin) / normal.dot(ray);
}

//! Largest relative difference of the covered pixels' depth from the plane z = 0.
double worstPlaneError(const vpRenderedView &view, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
{
  double worst = 0.;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const double depth = static_cast<double>(view.depth[static_cast<std::size_t>(row * view.width + column)]);
      if (depth > 0.) {
        const double expected = planeDepth(cMo, cam, imageColumn(view, column), imageRow(view, row));
        worst = std::max(worst, std::abs(depth / expected - 1.));
      }
    }
  }
  return worst;
}
} // namespace

TEST_CASE("A square that faces the camera has its depth and exactly its pixels", "[renderer]")
{
  // Its edges run through pixel centres: of opposite ones, one side belongs to the square and the other does not.
  const vpCameraParameters cam(600., 600., 320., 240.);
  const vpRenderedView view = renderOnCpu(makeSquare(0.1), vpHomogeneousMatrix(0., 0., 0.5, 0., 0., 0.), cam);
  CHECK(coveredPixels(view) == 120 * 120);
  CHECK(depthAt(view, 260, 180) == Approx(0.5).epsilon(1e-6));
  CHECK(depthAt(view, 379, 299) == Approx(0.5).epsilon(1e-6));
  CHECK(depthAt(view, 259, 240) == exactly(0.));
  CHECK(depthAt(view, 380, 240) == exactly(0.));
  CHECK(depthAt(view, 320, 179) == exactly(0.));
  CHECK(depthAt(view, 320, 300) == exactly(0.));
  CHECK(view.left == 258);
  CHECK(view.top == 178);
  CHECK(view.width == 125);
  CHECK(view.height == 125);
}

TEST_CASE("A tilted plane has the depth of the plane equation, from both sides", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const ModelPointer square = makeSquare(0.2);
  for (const double tilt : {0.3, 1.0, 1.4, 2.5, 3.6}) {
    const vpHomogeneousMatrix cMo(0.02, -0.03, 0.5, tilt, 0.4 * tilt, 0.1);
    const vpRenderedView view = renderOnCpu(square, cMo, cam);
    CHECK(coveredPixels(view) > 1000);
    CHECK(worstPlaneError(view, cMo, cam) < 1e-5);
  }
}

TEST_CASE("The silhouette has the area of the projected polygon", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const double h = 0.075;
  const ModelPointer square = makeSquare(2. * h);
  for (int trial = 0; trial < 10; ++trial) {
    const vpHomogeneousMatrix cMo(0.01 * trial, -0.02, 0.5, 0.1 * trial, -0.08 * trial, 0.3 * trial);
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector2d &p :
         {Eigen::Vector2d(-h, -h), Eigen::Vector2d(-h, h), Eigen::Vector2d(h, h), Eigen::Vector2d(h, -h)}) {
      corners.push_back(project(cMo, cam, Eigen::Vector3d(p.x(), p.y(), 0.)));
    }
    double twiceArea = 0.;
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector2d &p = corners[i];
      const Eigen::Vector2d &q = corners[(i + 1) % 4];
      twiceArea += p.x() * q.y() - p.y() * q.x();
    }
    const long covered = coveredPixels(renderOnCpu(square, cMo, cam));
    CHECK(static_cast<double>(covered) == Approx(std::abs(twiceArea) / 2.).epsilon(0.01));
  }
}

TEST_CASE("Triangles that share an edge leave no gap and draw no pixel twice", "[renderer]")
{
  const vpCameraParameters cam(600., 600., 320., 240.);
  const vpHomogeneousMatrix cMo(0., 0., 0.6, 0., 0., 0.);
  std::mt19937 random(11);
  const auto uniform = [&random] { return static_cast<double>(random()) / 4294967295. - 0.5; };
  for (int trial = 0; trial < 50; ++trial) {
    // A fan around a point inside a quadrangle; every second one has edges through pixel centres.
    const double grid = trial % 2 == 0 ? 0.001 : 1e-9;
    const auto corner = [&](double x, double y) {
      return makeCorner(grid * std::round((x + 0.03 * uniform()) / grid),
                        grid * std::round((y + 0.03 * uniform()) / grid), 0.);
    };
    const std::array<vpTrackedModelBuilder::Corner, 4> rim = {
        {corner(-0.04, -0.04), corner(0.04, -0.04), corner(0.04, 0.04), corner(-0.04, 0.04)}};
    const vpTrackedModelBuilder::Corner middle = corner(0., 0.);
    vpTrackedModelBuilder whole;
    long separate = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      vpTrackedModelBuilder part;
      part.addTriangle({{middle, rim[i], rim[(i + 1) % 4]}});
      whole.addTriangle({{middle, rim[i], rim[(i + 1) % 4]}});
      separate += coveredPixels(renderOnCpu(build(part), cMo, cam));
    }
    const vpRenderedView view = renderOnCpu(build(whole), cMo, cam);
    CHECK(coveredPixels(view) == separate);
    // The quadrangle is convex: one run of pixels in every row.
    int runs = 0;
    int rows = 0;
    for (int row = 0; row < view.height; ++row) {
      bool before = false;
      bool any = false;
      for (int column = 0; column < view.width; ++column) {
        const bool covered = view.depth[static_cast<std::size_t>(row * view.width + column)] > 0.F;
        runs += covered && !before ? 1 : 0;
        any = any || covered;
        before = covered;
      }
      rows += any ? 1 : 0;
    }
    CHECK(rows > 50);
    CHECK(runs == rows);
  }
}

TEST_CASE("Small triangles and large ones agree where they tile the same square", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const vpHomogeneousMatrix cMo(0.01, 0.02, 0.5, 0.5, -0.3, 0.2);
  const int cells = 40;
  const double h = 0.08;
  const auto at = [&](int i, int j) { return makeCorner(h * (2. * i / cells - 1.), h * (2. * j / cells - 1.), 0.); };
  vpTrackedModelBuilder fine;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      fine.addTriangle({{at(i, j), at(i, j + 1), at(i + 1, j + 1)}});
      fine.addTriangle({{at(i, j), at(i + 1, j + 1), at(i + 1, j)}});
    }
  }
  const vpRenderedView small = renderOnCpu(build(fine), cMo, cam);
  const vpRenderedView large = renderOnCpu(makeSquare(2. * h), cMo, cam);
  // The border's many corners are rounded one by one, hence a few pixels.
  CHECK(std::abs(coveredPixels(small) - coveredPixels(large)) <= 8);
  CHECK(worstPlaneError(small, cMo, cam) < 1e-5);
}

TEST_CASE("What is closer than the near plane is cut away", "[renderer]")
{
  // A floor from behind the camera to far in front of it.
  const vpCameraParameters cam(600., 600., 320., 240.);
  const vpHomogeneousMatrix cMo(0., 0.1, 0.5, pi / 2., 0., 0.);
  vpRenderOptions options;
  for (const double nearDistance : {0.001, 0.35}) {
    options.nearDistance = nearDistance;
    const vpRenderedView view = renderOnCpu(makeSquare(4.), cMo, cam, options);
    CHECK(view.width == 640);
    CHECK(view.height == 480);
    CHECK(worstPlaneError(view, cMo, cam) < 1e-5);
    float nearest = std::numeric_limits<float>::infinity();
    for (const float depth : view.depth) {
      nearest = depth > 0.F ? std::min(nearest, depth) : nearest;
    }
    // Of rows v the floor's depth is 60 / (v - 240): the last image row sees 60 / 239.
    CHECK(static_cast<double>(nearest) == Approx(nearDistance > 0.3 ? 60. / 171. : 60. / 239.).epsilon(1e-5));
    // It ends 2.5 m ahead, 24 rows below the horizon.
    CHECK(depthAt(view, 320, 270) == Approx(2.).epsilon(1e-5));
    CHECK(depthAt(view, 320, 260) == exactly(0.));
  }
}

TEST_CASE("An object is cut at the image's border, and outside it there is nothing", "[renderer]")
{
  const vpCameraParameters cam(600., 600., 320., 240.);
  const ModelPointer square = makeSquare(0.1);
  // Its left half is outside: the optical axis of column 0 is at X = -320 / 600 Z.
  const vpRenderedView half = renderOnCpu(square, vpHomogeneousMatrix(-320. / 600. * 0.5, 0., 0.5, 0., 0., 0.), cam);
  CHECK(half.left == 0);
  CHECK(half.width == 63);
  CHECK(coveredPixels(half) == 60 * 120);

  for (const vpHomogeneousMatrix &cMo :
       {vpHomogeneousMatrix(-1., 0., 0.5, 0., 0., 0.), vpHomogeneousMatrix(0., 3., 0.5, 0., 0., 0.),
        vpHomogeneousMatrix(0., 0., -0.5, 0., 0., 0.)}) {
    const vpRenderedView view = renderOnCpu(square, cMo, cam, allChannels());
    CHECK(view.width * view.height == 0);
    CHECK(view.depth.empty());
    CHECK(view.normal.empty());
    CHECK(view.face.empty());
    CHECK(view.color.empty());
    CHECK(view.index(320., 240.) == -1);
  }
}

TEST_CASE("A scaled crop says where in the image its pixels are", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const vpHomogeneousMatrix cMo(0.02, -0.03, 0.5, 0.7, 0.4, 0.1);
  const ModelPointer square = makeSquare(0.2);
  vpRenderOptions options;
  const long covered = coveredPixels(renderOnCpu(square, cMo, cam));
  for (const double scale : {0.5, 0.37}) {
    options.scale = scale;
    const vpRenderedView view = renderOnCpu(square, cMo, cam, options);
    CHECK(worstPlaneError(view, cMo, cam) < 1e-5);
    CHECK(static_cast<double>(coveredPixels(view)) ==
          Approx(scale * scale * static_cast<double>(covered)).epsilon(0.02));
    for (int row = 0; row < view.height; ++row) {
      const int column = row % view.width;
      CHECK(view.index(imageColumn(view, column), imageRow(view, row)) == row * view.width + column);
    }
    CHECK(view.index(imageColumn(view, -1), imageRow(view, 0)) == -1);
    CHECK(view.index(imageColumn(view, 0), imageRow(view, view.height)) == -1);
    CHECK(view.index(std::nan(""), 0.) == -1);
  }
}

TEST_CASE("A crop keeps its largest size", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const ModelPointer square = makeSquare(0.2);
  std::mt19937 random(4);
  vpRenderOptions options;
  for (int trial = 0; trial < 50; ++trial) {
    options.maxSize = 1 + static_cast<unsigned int>(trial) * 4;
    const vpHomogeneousMatrix cMo = randomPose(random, 0.4);
    const vpRenderedView view = renderOnCpu(square, cMo, cam, options);
    const int side = std::max(view.width, view.height);
    CHECK(side <= static_cast<int>(options.maxSize));
    CHECK(side > 0.9 * std::min(side, static_cast<int>(options.maxSize)) - 3.);
    // Corners are rounded to 1/1024 pixel, which is long where the whole object has a few pixels.
    CHECK(worstPlaneError(view, cMo, cam) < 1e-3);
  }
}
