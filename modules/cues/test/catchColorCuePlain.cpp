// SPDX-License-Identifier: GPL-2.0-or-later
#include "colorScenes.h"

#include <catchMain.h>
#include <countAllocations.h>

using namespace colorScenes;

namespace {
using countAllocations::allocations;

const vpHomogeneousMatrix cMo(0.01, -0.02, 0.5, 0.5, 0.6, 0.2);

bool isFinite(const vpResidualBlock &block)
{
  for (const vpResidual &row : block.rows) {
    if (!std::isfinite(row.error) || !row.jacobian.allFinite() || !(row.weight >= 0. && row.weight <= 1.)) {
      return false;
    }
  }
  return true;
}

// Largest information of all levels about the object's place in the image, 1 / square pixel: how far the rows would
// hold it.
double information(Scene &scene, const vpCueFrame &frame)
{
  vpColorCue cue;
  vpResidualBlock block;
  double most = 0.;
  for (int k = 0; k < 2; ++k) {
    for (unsigned int level = 0; level < cue.levels(); ++level) {
      cue.setLevel(level);
      cue.match(frame, scene.look(cMo));
      for (const double u : {0., 0.5, 3., 40.}) {
        cue.residuals(shifted(cMo, u, 0.3 * u), block);
        REQUIRE(block.rows.size() == cue.lines().size());
        REQUIRE(isFinite(block));
      }
      cue.residuals(cMo, block);
      const Normal normal(block, std::vector<double>(block.rows.size(), 1.));
      const double metresPerPixel = 0.5 / focal;
      most = std::max(most, normal.A(0, 0) * metresPerPixel * metresPerPixel);
    }
    cue.updateReference(cMo, std::vector<double>(block.rows.size(), 1.));
  }
  return most;
}

vpImage<vpRGBa> fill(double level, double noise)
{
  vpImage<vpRGBa> I(height, width);
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 0; j < width; ++j) {
      unsigned char values[3];
      for (int c = 0; c < 3; ++c) {
        const double x = level + noise * (hashed(static_cast<int>(i), static_cast<int>(j), c) - 0.5);
        values[c] = static_cast<unsigned char>(std::min(std::max(x, 0.), 255.));
      }
      I[i][j] = vpRGBa(values[0], values[1], values[2]);
    }
  }
  return I;
}
} // namespace

TEST_CASE("where object and background are alike, the rows hold nothing", "[color-plain]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> colors = scene.draw(cMo);
  const double normal = information(scene, source.frame(colors, makeCamera(), nullptr));
  CHECK(normal > 100.);
  for (const double level : {0., 255., 128.}) {
    const vpImage<vpRGBa> I = fill(level, 0.);
    CHECK(information(scene, source.frame(I, makeCamera(), nullptr)) < 1e-3 * normal);
    vpImage<unsigned char> gray;
    vpImageConvert::convert(I, gray);
    CHECK(information(scene, source.frame(gray, makeCamera(), nullptr)) < 1e-3 * normal);
  }
  const vpImage<vpRGBa> noisy = fill(128., 30.);
  CHECK(information(scene, source.frame(noisy, makeCamera(), nullptr)) < 0.1 * normal);
}

TEST_CASE("a view without silhouette gives no row", "[color-plain]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> I = scene.draw(cMo);
  const vpHomogeneousMatrix behind(0., 0., -1., 0., 0., 0.);
  vpColorCue cue;
  vpResidualBlock block;
  for (unsigned int level = 0; level < cue.levels(); ++level) {
    cue.setLevel(level);
    cue.match(source.frame(I, makeCamera(), nullptr), scene.look(behind));
    cue.residuals(cMo, block);
    CHECK(block.rows.empty());
    cue.updateReference(cMo, {});
    CHECK_FALSE(cue.histograms().isKnown());
  }
  std::vector<vpCueFeature> features(3);
  cue.getFeatures(cMo, {}, features);
  CHECK(features.empty());
}

TEST_CASE("features are the lines' points, outliers where the rows' weights say so", "[color-plain]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> I = scene.draw(cMo);
  vpColorCueSettings settings;
  settings.rows = GENERATE(vpColorCueSettings::LINES, vpColorCueSettings::PIXELS);
  vpColorCue cue(settings);
  cue.match(source.frame(I, makeCamera(), nullptr), scene.look(cMo));
  vpResidualBlock block;
  cue.residuals(cMo, block);
  std::vector<double> weights(block.rows.size(), 1.);
  const std::size_t perLine = block.rows.size() / cue.lines().size();
  std::fill(weights.begin(), weights.begin() + static_cast<std::ptrdiff_t>(perLine / 2 + 1), 0.);
  std::vector<vpCueFeature> features;
  cue.getFeatures(cMo, weights, features);
  REQUIRE(features.size() == cue.lines().size());
  for (std::size_t i = 0; i < features.size(); ++i) {
    CHECK(features[i].u == Approx(cue.lines()[i].pixel.x()));
    CHECK(features[i].v == Approx(cue.lines()[i].pixel.y()));
    // Of a line's pixels some may be outliers.
    const bool isOutlier = i == 0 && settings.rows == vpColorCueSettings::LINES;
    CHECK(features[i].state == (isOutlier ? vpFeatureState::OUTLIER : vpFeatureState::GOOD));
  }
}

TEST_CASE("nothing is allocated once there is memory", "[color-plain]")
{
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> I = scene.draw(cMo);
  vpColorCueSettings settings;
  settings.rows = GENERATE(vpColorCueSettings::LINES, vpColorCueSettings::PIXELS);
  vpColorCue cue(settings);
  vpResidualBlock block;
  std::vector<double> weights;
  std::size_t before = 0;
  for (int k = 0; k < 4; ++k) {
    before = k == 2 ? allocations : before;
    const vpCueFrame frame = source.frame(I, makeCamera(), nullptr);
    const vpModelView &view = scene.look(cMo);
    for (unsigned int level = 0; level < cue.levels(); ++level) {
      cue.setLevel(level);
      cue.match(frame, view);
      cue.residuals(cMo, block);
    }
    weights.assign(block.rows.size(), 1.);
    cue.updateReference(cMo, weights);
  }
  CHECK(allocations == before);
}
