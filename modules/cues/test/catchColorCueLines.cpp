// SPDX-License-Identifier: GPL-2.0-or-later
#include "colorScenes.h"

#include <catchMain.h>

using namespace colorScenes;

namespace {
const vpHomogeneousMatrix front(0.003, -0.002, 0.5, 0., 0., 0.);

std::vector<vpColorCue::Line> linesOf(Scene &scene, const vpHomogeneousMatrix &cMo, unsigned int level,
                                      const vpImage<bool> *mask = nullptr)
{
  const vpImage<vpRGBa> I = scene.draw(cMo);
  vpFrameSource source;
  vpColorCue cue;
  cue.setLevel(level);
  cue.match(source.frame(I, makeCamera(), mask), scene.look(cMo));
  return cue.lines();
}

Eigen::Vector2d at(const vpColorCue::Line &line, int offset)
{
  return line.pixel + offset * line.normal;
}

// How many of the pixels of all lines are on the wrong side of the silhouette, as a second drawing has it; those nearer
// than \e margin to the contour do not count.
std::size_t pixelsOnWrongSide(Scene &scene, const vpHomogeneousMatrix &cMo, const std::vector<vpColorCue::Line> &lines,
                              int margin)
{
  Paint paint;
  paint.object = [](const Eigen::Vector3d &) { return Color(255., 255., 255.); };
  paint.background = [](double, double) { return Color(0., 0., 0.); };
  const vpImage<vpRGBa> I = scene.draw(cMo, paint);
  std::size_t wrong = 0;
  for (const vpColorCue::Line &line : lines) {
    for (int k = line.first; k <= line.last; ++k) {
      const Eigen::Vector2d pixel = at(line, k);
      const bool isObject =
          I[static_cast<unsigned int>(pixel.y() + 0.5)][static_cast<unsigned int>(pixel.x() + 0.5)].R > 127;
      wrong += std::abs(k) >= margin && isObject != (k < 0);
    }
  }
  return wrong;
}

std::size_t pixelsOf(const std::vector<vpColorCue::Line> &lines)
{
  std::size_t sum = 0;
  for (const vpColorCue::Line &line : lines) {
    sum += static_cast<std::size_t>(line.last - line.first);
  }
  return sum;
}
} // namespace

TEST_CASE("lines end where the object ends or begins again", "[color-lines]")
{
  // A frame of bars 12 mm wide, an L, a thin plate, a body that is round: their parts are a few pixels apart.
  const std::vector<vpTrackedModel> models = {
      modelShapes::build(modelShapes::framePolygons(0.16, 0.012)),
      modelShapes::build(modelShapes::lPolygons(0.12, 0.02)),
      modelShapes::build(modelShapes::boxPolygons({0.2, 0.02, 0.02})),
      makeLump(),
  };
  const std::vector<vpHomogeneousMatrix> poses = {front, vpHomogeneousMatrix(-0.02, -0.03, 0.45, 0.5, 0.4, 0.3),
                                                  vpHomogeneousMatrix(0., 0., 0.6, -0.4, 0.7, 1.2)};
  for (const vpTrackedModel &model : models) {
    Scene scene(model);
    for (const vpHomogeneousMatrix &cMo : poses) {
      for (const unsigned int level : {0U, 2U, 4U}) {
        const std::vector<vpColorCue::Line> lines = linesOf(scene, cMo, level);
        INFO(model.report().file << " level " << level << " lines " << lines.size());
        CHECK(static_cast<double>(pixelsOnWrongSide(scene, cMo, lines, 2)) <
              0.01 * static_cast<double>(pixelsOf(lines)));
        if (level == 4) {
          CHECK(lines.size() > 30);
        }
      }
    }
  }
}

TEST_CASE("lines are spread over the whole silhouette, and no more than asked for", "[color-lines]")
{
  Scene scene(makeBox());
  const vpImage<vpRGBa> I = scene.draw(front);
  vpFrameSource source;
  vpColorCueSettings settings;
  settings.spacing = 1.;
  for (const unsigned int most : {20U, 50U, 100U}) {
    settings.lines = most;
    vpColorCue cue(settings);
    cue.match(source.frame(I, makeCamera(), nullptr), scene.look(front));
    CHECK(cue.lines().size() <= most);
    CHECK(cue.lines().size() > most * 7 / 10);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const vpColorCue::Line &line : cue.lines()) {
      sum += line.normal;
    }
    CHECK(sum.norm() < 0.15 * most); // As many on one side as on the other.
  }
  settings.spacing = 20.;
  settings.lines = 200;
  vpColorCue cue(settings);
  cue.match(source.frame(I, makeCamera(), nullptr), scene.look(front));
  for (std::size_t i = 1; i < cue.lines().size(); ++i) {
    CHECK((cue.lines()[i].pixel - cue.lines()[i - 1].pixel).norm() > 12.);
  }
}

TEST_CASE("no line has a masked pixel", "[color-lines]")
{
  Scene scene(makeBox());
  vpImage<bool> mask(height, width, true);
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 0; j < width; ++j) {
      mask[i][j] = (i / 20 + j / 30) % 3 != 0;
    }
  }
  for (const unsigned int level : {0U, 4U}) {
    const std::vector<vpColorCue::Line> all = linesOf(scene, front, level);
    const std::vector<vpColorCue::Line> seen = linesOf(scene, front, level, &mask);
    CHECK(seen.size() < all.size());
    CHECK(seen.size() > 10);
    for (const vpColorCue::Line &line : seen) {
      for (int k = line.first; k <= line.last; ++k) {
        const Eigen::Vector2d pixel = at(line, k);
        // Half a hundredth of a pixel aside, another one is the nearest.
        const Eigen::Vector2d fraction = (pixel.array() + 0.5) - (pixel.array() + 0.5).floor();
        if (fraction.minCoeff() > 0.01 && fraction.maxCoeff() < 0.99) {
          REQUIRE(mask[static_cast<unsigned int>(pixel.y() + 0.5)][static_cast<unsigned int>(pixel.x() + 0.5)]);
        }
      }
    }
  }
  const vpImage<bool> nothing(height, width, false);
  CHECK(linesOf(scene, front, 4, &nothing).empty());
}

TEST_CASE("lines stay inside the image", "[color-lines]")
{
  Scene scene(makeBox());
  for (const double u : {-150., -100., 120., 160.}) {
    for (const unsigned int level : {0U, 4U}) {
      const std::vector<vpColorCue::Line> lines = linesOf(scene, shifted(front, u, 0.6 * u), level);
      for (const vpColorCue::Line &line : lines) {
        for (const int k : {line.first, line.last}) {
          const Eigen::Vector2d pixel = at(line, k);
          CHECK((pixel.array() >= 0.).all());
          CHECK(pixel.x() <= width - 1.);
          CHECK(pixel.y() <= height - 1.);
        }
      }
    }
  }
  CHECK(linesOf(scene, shifted(front, 1000., 0.), 4).empty());
}

TEST_CASE("what the lens did not see is not used", "[color-lines]")
{
  Scene scene(makeBox());
  const vpHomogeneousMatrix corner = shifted(front, 90., 70.);
  const vpImage<vpRGBa> I = scene.draw(corner);
  vpCameraParameters cam = makeCamera();
  cam.initPersProjWithDistortion(focal, focal, cam.get_u0(), cam.get_v0(), 0.4, -0.4);
  vpFrameSource source;
  const vpCueFrame frame = source.frame(I, cam, nullptr);
  vpColorCue cue;
  cue.match(frame, scene.look(corner));
  CHECK_FALSE(cue.lines().empty());
  CHECK(cue.lines().size() < linesOf(scene, corner, 4).size());
  for (const vpColorCue::Line &line : cue.lines()) {
    for (int k = line.first; k <= line.last; ++k) {
      const Eigen::Vector2d pixel = at(line, k);
      CHECK_FALSE(frame.isMasked(std::floor(pixel.x() + 0.5), std::floor(pixel.y() + 0.5)));
    }
  }
}
