// SPDX-License-Identifier: GPL-2.0-or-later
#include "colorScenes.h"

#include <catchMain.h>

using namespace colorScenes;

namespace {
const vpHomogeneousMatrix cMo(0.01, -0.02, 0.5, 0.5, 0.6, 0.2);

vpColorCueSettings rows(vpColorCueSettings::Rows kind)
{
  vpColorCueSettings settings;
  settings.rows = kind;
  return settings;
}

double halfSquares(const vpColorCue &cue, const vpHomogeneousMatrix &pose)
{
  vpResidualBlock block;
  cue.residuals(pose, block);
  double sum = 0.;
  for (const vpResidual &row : block.rows) {
    sum += 0.5 * row.error * row.error;
  }
  return sum;
}

// A pose some tenths of a pixel to a pixel off the matched one.
vpHomogeneousMatrix nearby()
{
  Eigen::Matrix<double, 6, 1> velocity;
  velocity << 0.0008, -0.0005, 0.001, 0.002, -0.001, 0.006;
  return movedBy(cMo, velocity);
}

bool isColor(int i)
{
  return i == 0;
}
} // namespace

TEST_CASE("interaction matrices are the derivatives of the errors", "[color-jacobian]")
{
  Scene scene(GENERATE(0, 1) == 0 ? makeBox() : makeLump());
  const vpImage<vpRGBa> I = scene.draw(shifted(cMo, 1.5, -1.));
  vpImage<unsigned char> gray;
  vpImageConvert::convert(I, gray);
  vpFrameSource source;
  const bool color = isColor(GENERATE(0, 1));
  const vpCueFrame frame = color ? source.frame(I, makeCamera(), nullptr) : source.frame(gray, makeCamera(), nullptr);
  vpColorCue cue(rows(vpColorCueSettings::PIXELS));
  vpResidualBlock block;
  vpResidualBlock before;
  vpResidualBlock after;
  std::size_t telling = 0;
  for (unsigned int level = 0; level < cue.levels(); ++level) {
    cue.setLevel(level);
    cue.match(frame, scene.look(cMo));
    cue.residuals(nearby(), block);
    const bool isFine = level >= cue.settings().scales.size();
    REQUIRE(block.rows.size() >= (isFine ? (color ? 15U : 5U) : 1U) * cue.lines().size());
    const double step = 1e-6;
    for (int i = 0; i < 6; ++i) {
      cue.residuals(movedBy(nearby(), velocityAlong(i, -step)), before);
      cue.residuals(movedBy(nearby(), velocityAlong(i, step)), after);
      REQUIRE(after.rows.size() == block.rows.size());
      for (std::size_t j = 0; j < block.rows.size(); ++j) {
        const double difference = (after.rows[j].error - before.rows[j].error) / (2. * step);
        const double norm = block.rows[j].jacobian.norm();
        if (std::fabs(difference - block.rows[j].jacobian[i]) > 1e-4 * norm + 1e-3) {
          FAIL_CHECK("level " << level << " row " << j << " component " << i << ": " << difference << " and "
                              << block.rows[j].jacobian[i]);
        }
        telling += norm > 10.;
      }
    }
  }
  CHECK(telling > 1000);
}

TEST_CASE("a row for a line stands for the rows of its pixels", "[color-jacobian]")
{
  Scene scene(makeBox());
  const vpImage<vpRGBa> I = scene.draw(shifted(cMo, 1., 0.5));
  vpFrameSource source;
  const vpCueFrame frame = source.frame(I, makeCamera(), nullptr);
  vpColorCue lines(rows(vpColorCueSettings::LINES));
  vpColorCue pixels(rows(vpColorCueSettings::PIXELS));
  lines.match(frame, scene.look(cMo));
  pixels.match(frame, scene.look(cMo));
  vpResidualBlock lineBlock;
  vpResidualBlock pixelBlock;
  for (const vpHomogeneousMatrix &pose : {cMo, nearby()}) {
    lines.residuals(pose, lineBlock);
    pixels.residuals(pose, pixelBlock);
    REQUIRE(lineBlock.rows.size() == lines.lines().size());
    CHECK(pixelBlock.rows.size() > 20 * lineBlock.rows.size());
    const Normal of(lineBlock, std::vector<double>(lineBlock.rows.size(), 1.));
    const Normal all(pixelBlock, std::vector<double>(pixelBlock.rows.size(), 1.));
    CHECK((of.A - all.A).norm() < 1e-4 * all.A.norm());
    CHECK((of.b - all.b).norm() < 1e-4 * all.b.norm());

    // So their right side is the derivative of half the sum of squares.
    const double step = 1e-5;
    for (int i = 0; i < 6; ++i) {
      const double after = halfSquares(pixels, movedBy(pose, velocityAlong(i, step)));
      const double before = halfSquares(pixels, movedBy(pose, velocityAlong(i, -step)));
      CHECK((after - before) / (2. * step) == Approx(-of.b[i]).epsilon(1e-3).margin(1e-3 * of.b.norm()));
    }
  }
}

TEST_CASE("a line's error is the offset of its contour in standard deviations", "[color-jacobian]")
{
  // Two plain colours: the contour is where they meet, and each row alone finds it.
  Scene scene(makeBox());
  Paint paint;
  paint.object = [](const Eigen::Vector3d &) { return Color(180., 60., 40.); };
  paint.background = [](double, double) { return Color(70., 80., 110.); };
  const vpImage<vpRGBa> I = scene.draw(cMo, paint);
  vpFrameSource source;
  vpColorCue cue;
  learn(cue, scene, source.frame(I, makeCamera(), nullptr), cMo);
  vpResidualBlock block;
  for (unsigned int level = 0; level < cue.levels(); ++level) {
    cue.setLevel(level);
    cue.match(source.frame(I, makeCamera(), nullptr), scene.look(cMo));
    const vpHomogeneousMatrix pose = shifted(cMo, 0.4, 0.);
    cue.residuals(pose, block);
    CHECK(block.noise == exactly(1.));
    // Coarse levels tell the contour's place to a share of the pixels that they take together.
    const std::vector<unsigned int> &scales = cue.settings().scales;
    const double tolerance = level < scales.size() ? 0.5 + 0.15 * scales[level] : 0.5;
    std::size_t good = 0;
    std::size_t across = 0;
    for (std::size_t i = 0; i < cue.lines().size(); ++i) {
      const vpResidual &row = block.rows[i];
      // By the camera's velocity along u the contour moves by -focal / Z n_u pixels, Z near 0.5 m.
      const double n = cue.lines()[i].normal.x();
      if (std::fabs(n) < 0.3) {
        continue;
      }
      const double deviations = -row.jacobian[0] / n / (focal / 0.5); // For one pixel.
      good += std::fabs(row.error / deviations - 0.4 * n) < tolerance && deviations > 0.15;
      ++across;
    }
    INFO("level " << level << ": " << good << " of " << across);
    CHECK(across > 40);
    CHECK(static_cast<double>(good) > 0.9 * static_cast<double>(across));
  }
}

TEST_CASE("points behind the camera have no weight", "[color-jacobian]")
{
  Scene scene(makeBox());
  const vpImage<vpRGBa> I = scene.draw(cMo);
  vpFrameSource source;
  const vpCueFrame frame = source.frame(I, makeCamera(), nullptr);
  for (const vpColorCueSettings::Rows kind : {vpColorCueSettings::LINES, vpColorCueSettings::PIXELS}) {
    vpColorCue cue(rows(kind));
    for (unsigned int level = 0; level < cue.levels(); ++level) {
      cue.setLevel(level);
      cue.match(frame, scene.look(cMo));
      vpHomogeneousMatrix behind = cMo;
      behind[2][3] = -0.5;
      vpResidualBlock block;
      cue.residuals(behind, block);
      REQUIRE(block.rows.size() >= cue.lines().size());
      for (const vpResidual &row : block.rows) {
        REQUIRE(row.weight == exactly(0.));
        REQUIRE(row.error == exactly(0.));
        REQUIRE(row.jacobian.isZero());
      }
      CHECK_NOTHROW(cue.updateReference(behind, std::vector<double>(block.rows.size(), 1.)));
    }
  }
}
