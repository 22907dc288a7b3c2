// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpCpuRenderer.h>

#include "renderModels.h"

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <Eigen/Geometry>

#include <limits>

namespace {
constexpr unsigned int imageWidth = 640;
constexpr unsigned int imageHeight = 480;

vpRenderedView render(const ModelPointer &model, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                      const vpRenderOptions &options = vpRenderOptions())
{
  vpRenderedView view;
  vpCpuRenderer(model).render(cMo, cam, imageWidth, imageHeight, options, view);
  return view;
}

vpRenderOptions allChannels()
{
  vpRenderOptions options;
  options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL | vpRenderOptions::FACE | vpRenderOptions::COLOR;
  return options;
}

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

//! Image point of the centre of crop pixel (row, column), as vpRenderedView documents it.
double imageColumn(const vpRenderedView &view, int column)
{
  return (view.left + column + 0.5) / view.scale - 0.5;
}
double imageRow(const vpRenderedView &view, int row)
{
  return (view.top + row + 0.5) / view.scale - 0.5;
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
  const vpRenderedView view = render(makeSquare(0.1), vpHomogeneousMatrix(0., 0., 0.5, 0., 0., 0.), cam);
  CHECK(coveredPixels(view) == 120 * 120);
  CHECK(depthAt(view, 260, 180) == Approx(0.5).epsilon(1e-6));
  CHECK(depthAt(view, 379, 299) == Approx(0.5).epsilon(1e-6));
  CHECK(depthAt(view, 259, 240) == 0.);
  CHECK(depthAt(view, 380, 240) == 0.);
  CHECK(depthAt(view, 320, 179) == 0.);
  CHECK(depthAt(view, 320, 300) == 0.);
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
    const vpRenderedView view = render(square, cMo, cam);
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
    const long covered = coveredPixels(render(square, cMo, cam));
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
      separate += coveredPixels(render(build(part), cMo, cam));
    }
    const vpRenderedView view = render(build(whole), cMo, cam);
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
  const vpRenderedView small = render(build(fine), cMo, cam);
  const vpRenderedView large = render(makeSquare(2. * h), cMo, cam);
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
    const vpRenderedView view = render(makeSquare(4.), cMo, cam, options);
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
    CHECK(depthAt(view, 320, 260) == 0.);
  }
}

TEST_CASE("An object is cut at the image's border, and outside it there is nothing", "[renderer]")
{
  const vpCameraParameters cam(600., 600., 320., 240.);
  const ModelPointer square = makeSquare(0.1);
  // Its left half is outside: the optical axis of column 0 is at X = -320 / 600 Z.
  const vpRenderedView half = render(square, vpHomogeneousMatrix(-320. / 600. * 0.5, 0., 0.5, 0., 0., 0.), cam);
  CHECK(half.left == 0);
  CHECK(half.width == 63);
  CHECK(coveredPixels(half) == 60 * 120);

  for (const vpHomogeneousMatrix &cMo :
       {vpHomogeneousMatrix(-1., 0., 0.5, 0., 0., 0.), vpHomogeneousMatrix(0., 3., 0.5, 0., 0., 0.),
        vpHomogeneousMatrix(0., 0., -0.5, 0., 0., 0.)}) {
    const vpRenderedView view = render(square, cMo, cam, allChannels());
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
  const long covered = coveredPixels(render(square, cMo, cam));
  for (const double scale : {0.5, 0.37}) {
    options.scale = scale;
    const vpRenderedView view = render(square, cMo, cam, options);
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
    const vpRenderedView view = render(square, cMo, cam, options);
    const int side = std::max(view.width, view.height);
    CHECK(side <= static_cast<int>(options.maxSize));
    CHECK(side > 0.9 * std::min(side, static_cast<int>(options.maxSize)) - 3.);
    CHECK(worstPlaneError(view, cMo, cam) < 1e-5);
  }
}

TEST_CASE("Cylinder and sphere have their depth, normal and face on the axis", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const auto centre = [&cam](const vpRenderedView &view) {
    return static_cast<std::size_t>(view.index(cam.get_u0(), cam.get_v0()));
  };
  SECTION("sphere")
  {
    const vpRenderedView view =
        render(makeSphere(0.1, 36), vpHomogeneousMatrix(0., 0., 0.6, 0.3, 0.2, 0.1), cam, allChannels());
    CHECK(static_cast<double>(view.depth[centre(view)]) == Approx(0.5).epsilon(0.002));
    CHECK(view.normal[centre(view)].z() < -0.999F);
    CHECK(view.face[centre(view)] == 0);
    // The limb is the cone of half angle asin(r / d): its radius in the image is f r / sqrt(d^2 - r^2).
    const double area = pi * 600. * 610. * 0.01 / (0.36 - 0.01);
    CHECK(static_cast<double>(coveredPixels(view)) == Approx(area).epsilon(0.01));
  }
  SECTION("cylinder across the line of sight, seen on its mantle")
  {
    const vpRenderedView view =
        render(makeCylinder(0.05, 0.2), vpHomogeneousMatrix(0., 0., 0.6, pi / 2., 0., 0.), cam, allChannels());
    CHECK(static_cast<double>(view.depth[centre(view)]) == Approx(0.55).epsilon(0.005));
    CHECK(view.normal[centre(view)].z() < -0.99F);
    CHECK(view.face[centre(view)] >= 0);
  }
}

TEST_CASE("Normals are of unit length, look at the camera and follow the surface", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const vpHomogeneousMatrix cMo(0.03, -0.02, 0.6, 0.4, 0.2, -0.9);
  const Eigen::Vector3d centre(0.03, -0.02, 0.6);
  const vpRenderedView view = render(makeSphere(0.1, 50), cMo, cam, allChannels());
  double worstSphere = 0.;
  double worstLength = 0.;
  double mostAway = -1.;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const std::size_t i = static_cast<std::size_t>(row * view.width + column);
      if (view.depth[i] == 0.F) {
        CHECK(view.normal[i].isZero());
        continue;
      }
      const Eigen::Vector3d ray((imageColumn(view, column) - cam.get_u0()) / cam.get_px(),
                                (imageRow(view, row) - cam.get_v0()) / cam.get_py(), 1.);
      const Eigen::Vector3d normal = view.normal[i].cast<double>();
      const Eigen::Vector3d expected = (ray * static_cast<double>(view.depth[i]) - centre).normalized();
      worstSphere = std::max(worstSphere, (normal - expected).norm());
      worstLength = std::max(worstLength, std::abs(normal.norm() - 1.));
      mostAway = std::max(mostAway, normal.dot(ray.normalized()));
    }
  }
  CHECK(worstSphere < 0.06);
  CHECK(worstLength < 1e-5);
  CHECK(mostAway < 1e-5);

  // From behind, a square's normal is turned over.
  for (const double turn : {0.3, pi - 0.3}) {
    const vpRenderedView square =
        render(makeSquare(0.1), vpHomogeneousMatrix(0., 0., 0.5, turn, 0., 0.), cam, allChannels());
    const Eigen::Vector3f normal = square.normal[static_cast<std::size_t>(square.index(321., 239.))];
    CHECK(normal.z() == Approx(-std::cos(0.3)).epsilon(1e-5));
    CHECK(normal.y() == Approx(turn < 1. ? std::sin(0.3) : -std::sin(0.3)).epsilon(1e-5));
  }
}

TEST_CASE("Every pixel says which face it shows", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  const vpHomogeneousMatrix cMo(0., 0., 0.5, 2.5, 0.4, 0.3);
  const vpRenderedView view = render(box, cMo, cam, allChannels());
  std::vector<long> seen(box->faces().size(), 0);
  for (std::size_t i = 0; i < view.face.size(); ++i) {
    REQUIRE((view.face[i] >= 0) == (view.depth[i] > 0.F));
    if (view.face[i] >= 0) {
      const std::size_t face = static_cast<std::size_t>(view.face[i]);
      seen[face]++;
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      for (unsigned int k = 0; k < 3; ++k) {
        normal[static_cast<int>(k)] = cMo[k][0] * box->faces()[face].normal.x() +
                                      cMo[k][1] * box->faces()[face].normal.y() +
                                      cMo[k][2] * box->faces()[face].normal.z();
      }
      REQUIRE((view.normal[i].cast<double>() - normal).norm() < 1e-5);
    }
  }
  CHECK(std::count_if(seen.begin(), seen.end(), [](long pixels) { return pixels > 100; }) == 3);
}

TEST_CASE("Colours come from the texture, the corners or are gray", "[renderer]")
{
  const vpCameraParameters cam(600., 600., 320., 240.);
  const vpHomogeneousMatrix cMo(0., 0., 0.5, 0., 0., 0.);
  const auto at = [](double x, double y, double u, double v) {
    vpTrackedModelBuilder::Corner corner = makeCorner(x, y, 0.);
    corner.color = Eigen::Vector3f(static_cast<float>(u), static_cast<float>(v), 0.F);
    corner.texture = Eigen::Vector2f(static_cast<float>(u), static_cast<float>(v));
    return corner;
  };
  const std::array<vpTrackedModelBuilder::Corner, 4> corner = {
      {at(-0.05, -0.05, 0., 0.), at(0.05, -0.05, 1., 0.), at(0.05, 0.05, 1., 1.), at(-0.05, 0.05, 0., 1.)}};
  const auto colorAt = [&](const ModelPointer &model, double u, double v) {
    const vpRenderedView view = render(model, cMo, cam, allChannels());
    return view.color[static_cast<std::size_t>(view.index(u, v))];
  };
  SECTION("corner colours are interpolated")
  {
    vpTrackedModelBuilder builder;
    builder.addTriangle({{corner[0], corner[2], corner[1]}});
    builder.addTriangle({{corner[0], corner[3], corner[2]}});
    const vpRGBa color = colorAt(build(builder), 290., 210.);
    CHECK(std::abs(int(color.R) - 64) <= 1);
    CHECK(std::abs(int(color.G) - 64) <= 1);
    CHECK(int(color.B) == 0);
    CHECK(int(color.A) == 255);
  }
  SECTION("a texture is sampled between its texels")
  {
    vpImage<vpRGBa> image(2, 2);
    image[0][0] = vpRGBa(200, 0, 0, 255);
    image[0][1] = vpRGBa(0, 200, 0, 255);
    image[1][0] = vpRGBa(0, 0, 200, 255);
    image[1][1] = vpRGBa(100, 100, 100, 255);
    vpTrackedModelBuilder builder;
    const int index = builder.addImage(image);
    builder.addTriangle({{corner[0], corner[2], corner[1]}}, index);
    builder.addTriangle({{corner[0], corner[3], corner[2]}}, index);
    const ModelPointer model = build(builder);
    // The square is 120 pixels wide: texel centres are 30 pixels from its borders.
    const vpRGBa first = colorAt(model, 290., 210.);
    CHECK((first.R == 200 && first.G == 0 && first.B == 0 && first.A == 255));
    const vpRGBa right = colorAt(model, 350., 210.);
    CHECK((right.R == 0 && right.G == 200 && right.B == 0));
    const vpRGBa lower = colorAt(model, 290., 270.);
    CHECK((lower.R == 0 && lower.G == 0 && lower.B == 200));
    const vpRGBa middle = colorAt(model, 320., 240.);
    CHECK((middle.R == 75 && middle.G == 75 && middle.B == 75));
  }
  SECTION("without either, gray; nothing where there is no object")
  {
    const vpRGBa color = colorAt(makeSquare(0.1), 320., 240.);
    CHECK((color.R == 128 && color.G == 128 && color.B == 128 && color.A == 255));
    const vpRGBa outside = colorAt(makeSquare(0.1), 258., 240.);
    CHECK((outside.R == 0 && outside.G == 0 && outside.B == 0 && outside.A == 0));
  }
}

TEST_CASE("Hidden surfaces are hidden", "[renderer]")
{
  vpTrackedModelBuilder builder;
  for (const double z : {0.1, 0., 0.2}) {
    const double h = 0.02 + z;
    builder.addFace({{-h, -h, z}, {-h, h, z}, {h, h, z}, {h, -h, z}});
  }
  const vpCameraParameters cam(600., 600., 320., 240.);
  const vpRenderedView view = render(build(builder), vpHomogeneousMatrix(0., 0., 1., 0., 0., 0.), cam, allChannels());
  CHECK(depthAt(view, 320, 240) == Approx(1.));
  CHECK(depthAt(view, 340, 240) == Approx(1.1));
  CHECK(depthAt(view, 400, 240) == Approx(1.2));
  CHECK(view.face[static_cast<std::size_t>(view.index(320, 240))] == 1);
  CHECK(view.face[static_cast<std::size_t>(view.index(340, 240))] == 0);
  CHECK(view.face[static_cast<std::size_t>(view.index(400, 240))] == 2);
}

TEST_CASE("Memory is used again, and channels that are not asked for are empty", "[renderer]")
{
  const ModelPointer model = makeSphere(0.1, 20);
  vpCpuRenderer renderer(model);
  const vpHomogeneousMatrix cMo(0., 0., 0.6, 0.3, 0.2, 0.1);
  vpRenderedView view;
  renderer.render(cMo, makeCamera(), imageWidth, imageHeight, allChannels(), view);
  const vpRenderedView first = view;
  const void *depth = view.depth.data();
  const void *normal = view.normal.data();
  const void *color = view.color.data();
  renderer.render(cMo, makeCamera(), imageWidth, imageHeight, vpRenderOptions(), view);
  CHECK(view.depth == first.depth);
  CHECK(view.normal.empty());
  CHECK(view.face.empty());
  CHECK(view.color.empty());
  renderer.render(cMo, makeCamera(), imageWidth, imageHeight, allChannels(), view);
  CHECK(view.depth.data() == depth);
  CHECK(view.normal.data() == normal);
  CHECK(view.color.data() == color);
  CHECK(view.depth == first.depth);
  CHECK(view.face == first.face);
}

TEST_CASE("Unusable input is refused by name", "[renderer]")
{
  const ModelPointer model = makeSquare(0.1);
  vpCpuRenderer renderer(model);
  const vpHomogeneousMatrix cMo(0., 0., 0.5, 0., 0., 0.);
  const vpCameraParameters cam = makeCamera();
  vpRenderedView view;
  const auto message = [&](const vpHomogeneousMatrix &pose, const vpCameraParameters &camera, unsigned int width,
                           const vpRenderOptions &options) -> std::string {
    try {
      renderer.render(pose, camera, width, imageHeight, options, view);
    } catch (const vpException &e) {
      return e.getStringMessage();
    }
    return "";
  };
  vpHomogeneousMatrix broken = cMo;
  broken[0][3] = std::nan("");
  vpRenderOptions scale;
  scale.scale = 1.5;
  vpRenderOptions margin;
  margin.margin = -1.;
  vpRenderOptions nearDistance;
  nearDistance.nearDistance = 0.;
  vpRenderOptions channels;
  channels.channels = 64;
  CHECK(message(cMo, cam, imageWidth, vpRenderOptions()).empty());
  CHECK_THAT(message(cMo, cam, 0, vpRenderOptions()), ContainsSubstring("0 x 480"));
  CHECK_THAT(message(broken, cam, imageWidth, vpRenderOptions()), ContainsSubstring("cMo"));
  CHECK_THAT(message(cMo, vpCameraParameters(600., std::nan(""), 320., 240.), imageWidth, vpRenderOptions()),
             ContainsSubstring("py"));
  CHECK_THAT(message(cMo, cam, imageWidth, scale), ContainsSubstring("scale is 1.5"));
  CHECK_THAT(message(cMo, cam, imageWidth, margin), ContainsSubstring("margin"));
  CHECK_THAT(message(cMo, cam, imageWidth, nearDistance), ContainsSubstring("nearDistance"));
  CHECK_THAT(message(cMo, cam, imageWidth, channels), ContainsSubstring("channels is 64"));
  CHECK_THROWS_AS(vpCpuRenderer(nullptr), vpException);
  CHECK_THROWS_AS(vpModelRenderer::create(nullptr), vpException);
  CHECK(vpModelRenderer::create(model, vpModelRenderer::CPU)->name() == "CPU");
  CHECK(vpModelRenderer::create(model)->name() == "CPU");
}
