// SPDX-License-Identifier: GPL-2.0-or-later
// The library keeps it to itself.
#include "search/vpModelColors.cpp"

#include <catchMain.h>

#include <colorScenes.h>
#include <meshFiles.h>

#include <visp3/model/vpModelReader.h>

#include <fstream>

namespace {
using colorScenes::Color;
using colorScenes::hashed;

const vpHomogeneousMatrix truth(0.01, -0.01, 0.5, 0.9, 0.5, -0.2);
//! Half a turn about the object's z axis.
const vpHomogeneousMatrix turned = truth * vpHomogeneousMatrix(0., 0., 0., 0., 0., M_PI);
const Color gold(150., 110., 30.);
const Color gray(105., 105., 105.);

//! The box of colorScenes, gold where x is positive and gray, about as bright, where it is not.
std::string writeTintedBox(const std::string &name)
{
  std::ofstream file(name);
  const std::size_t count = 12;
  file << meshFiles::coloredPlyHeader(4 * count, count);
  for (const double x : {0.05, -0.05}) {
    for (const auto &side : modelShapes::boxPolygons({0.1, 0.14, 0.1}, {x, 0., 0.})) {
      for (const Eigen::Vector3d &corner : side) {
        file << corner.transpose() << " " << (x > 0. ? gold : gray).transpose() << "\n";
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    file << "4 " << 4 * i << " " << 4 * i + 1 << " " << 4 * i + 2 << " " << 4 * i + 3 << "\n";
  }
  return name;
}

//! What the box looks like: colours by place, glinting and dark from patch to patch as foil is where it is wrinkled.
vpImage<vpRGBa> draw(bool isWrinkled, const std::function<Color(const Eigen::Vector3d &)> &color)
{
  colorScenes::Paint paint;
  paint.object = [&](const Eigen::Vector3d &oX) -> Color {
    const double patch =
        hashed(colorScenes::cell(oX.x(), 0.006), colorScenes::cell(oX.y(), 0.006), colorScenes::cell(oX.z(), 0.006));
    return (isWrinkled ? (patch < 0.5 ? 0.3 : 2.) : 1.) * color(oX);
  };
  return colorScenes::Scene(colorScenes::makeBox()).draw(truth, paint);
}

Color own(const Eigen::Vector3d &oX)
{
  return oX.x() > 0. ? gold : gray;
}

struct Colors
{
  Colors()
      : model(std::make_shared<const vpTrackedModel>(
            vpModelReader::read(writeTintedBox(meshFiles::temporaryFile("tinted-box.ply")))))
  {
    colors.setModel(model);
  }

  double agreement(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo)
  {
    const vpCueFrame frame = source.frame(I, colorScenes::makeCamera(), nullptr);
    colors.setFrame(frame, sphere, vpModelRenderer::Preference::CPU);
    return colors.agreement(cMo);
  }

  std::shared_ptr<const vpTrackedModel> model;
  vpViewSphere sphere{model, vpViewSphereOptions(), vpModelRenderer::create(model, vpModelRenderer::Preference::CPU)};
  vpModelColors colors;
  vpFrameSource source;
};
} // namespace

TEST_CASE("The model's colours agree at the right pose alone", "[model-colors]")
{
  Colors box;
  const vpImage<vpRGBa> I = draw(false, own);
  CHECK(box.agreement(I, truth) > 0.5);
  CHECK(box.agreement(I, turned) < -0.5);
  CHECK(box.colors.trust() > 0.5);
}

TEST_CASE("Wrinkles of which the model knows nothing leave the tints", "[model-colors]")
{
  Colors box;
  const vpImage<vpRGBa> I = draw(true, own);
  CHECK(box.agreement(I, truth) > 0.5);
  CHECK(box.agreement(I, turned) < -0.3);
}

TEST_CASE("An object of other colours has none of the model's", "[model-colors]")
{
  Colors box;
  for (const bool isWrinkled : {false, true}) {
    const vpImage<vpRGBa> I =
        draw(isWrinkled, [](const Eigen::Vector3d &oX) -> Color { return oX.y() > 0. ? gold : gray; });
    CHECK(std::abs(box.agreement(I, truth)) < 0.25);
    CHECK(std::abs(box.agreement(draw(isWrinkled, [](const Eigen::Vector3d &) { return gold; }), truth)) < 0.2);
  }
}
