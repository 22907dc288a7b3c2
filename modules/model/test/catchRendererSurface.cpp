// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpCpuRenderer.h>

#include "renderModels.h"

#include <catchMain.h>

#include <Eigen/Geometry>

TEST_CASE("Cylinder and sphere have their depth, normal and face on the axis", "[renderer]")
{
  const vpCameraParameters cam = makeCamera();
  const auto centre = [&cam](const vpRenderedView &view) {
    return static_cast<std::size_t>(view.index(cam.get_u0(), cam.get_v0()));
  };
  SECTION("sphere")
  {
    const vpRenderedView view =
        renderOnCpu(makeSphere(0.1, 36), vpHomogeneousMatrix(0., 0., 0.6, 0.3, 0.2, 0.1), cam, allChannels());
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
        renderOnCpu(makeCylinder(0.05, 0.2), vpHomogeneousMatrix(0., 0., 0.6, pi / 2., 0., 0.), cam, allChannels());
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
  const vpRenderedView view = renderOnCpu(makeSphere(0.1, 50), cMo, cam, allChannels());
  double worstSphere = 0.;
  double worstLength = 0.;
  double mostAway = -1.;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      const std::size_t i = static_cast<std::size_t>(row * view.width + column);
      if (view.depth[i] == exactly(0.F)) {
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
        renderOnCpu(makeSquare(0.1), vpHomogeneousMatrix(0., 0., 0.5, turn, 0., 0.), cam, allChannels());
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
  const vpRenderedView view = renderOnCpu(box, cMo, cam, allChannels());
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
    const vpRenderedView view = renderOnCpu(model, cMo, cam, allChannels());
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
  const vpRenderedView view =
      renderOnCpu(build(builder), vpHomogeneousMatrix(0., 0., 1., 0., 0., 0.), cam, allChannels());
  CHECK(depthAt(view, 320, 240) == Approx(1.));
  CHECK(depthAt(view, 340, 240) == Approx(1.1));
  CHECK(depthAt(view, 400, 240) == Approx(1.2));
  CHECK(view.face[static_cast<std::size_t>(view.index(320, 240))] == 1);
  CHECK(view.face[static_cast<std::size_t>(view.index(340, 240))] == 0);
  CHECK(view.face[static_cast<std::size_t>(view.index(400, 240))] == 2);
}
