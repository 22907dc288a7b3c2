// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <catchMain.h>

#include <string>

using namespace edgeScenes;

namespace {
// How far the candidates of a cue are from an edge that is known.
struct Deviation
{
  double mean = 0.;
  double rms = 0.;
  double largest = 0.;
};

Deviation deviationFrom(const Line &edge, const vpEdgeCue &cue)
{
  Deviation deviation;
  for (const vpEdgeCue::Match &match : cue.matches()) {
    REQUIRE(match.count == 1);
    const vpEdgeCue::Candidate &candidate = cue.candidates()[static_cast<std::size_t>(match.first)];
    // Of the candidate's place on the image, towards the side of the edge's normal.
    const double error = edge.distance(match.point.pixel + candidate.offset * match.point.normal);
    deviation.mean += error;
    deviation.rms += error * error;
    deviation.largest = std::max(deviation.largest, std::fabs(error));
  }
  const double count = static_cast<double>(cue.matches().size());
  deviation.mean /= count;
  deviation.rms = std::sqrt(deviation.rms / count);
  return deviation;
}

vpEdgeCueSettings single(unsigned int maskSize)
{
  vpEdgeCueSettings settings;
  settings.candidates = 1;
  settings.maskSize = maskSize;
  settings.contrast = 20.;
  return settings;
}

// Orientations all around, with the axes and diagonals among them; the edge is somewhere between pixels.
std::vector<Line> edgesAllAround(int count)
{
  std::vector<Line> edges;
  for (int i = 0; i < count; ++i) {
    const double part = i / static_cast<double>(count);
    edges.push_back({Eigen::Vector2d(80. + 0.73 * part, 60. - 0.41 * part), 2. * M_PI * part});
  }
  return edges;
}
} // namespace

TEST_CASE("edges without noise are found to a few hundredths of a pixel", "[edge-search]")
{
  const unsigned int maskSize = GENERATE(3U, 5U, 7U);
  const double sigma = GENERATE(0., 0.5, 1., 2.);
  const double largestBias = maskSize == 3 ? 0.1 : 0.05; // Two gray levels, rounded to integers, tell no more.
  vpEdgeCue cue(single(maskSize));
  int i = 0;
  for (const Line &edge : edgesAllAround(16)) {
    const vpModelView view = viewOf({edge.moved(0.37 * (i++ % 16) - 2.9)});
    match(cue, drawStep(edge, 100., sigma), view);
    REQUIRE(cue.matches().size() > 15);
    const Deviation deviation = deviationFrom(edge, cue);
    INFO("mask " << maskSize << " sigma " << sigma << " angle " << edge.angle * 180. / M_PI);
    CHECK(std::fabs(deviation.mean) < largestBias);
    CHECK(deviation.largest < 0.15);
  }
}

TEST_CASE("noise moves edges by less than a fifth of a pixel", "[edge-search]")
{
  const double noise = GENERATE(2., 5.);
  const double sigma = GENERATE(0.5, 1.);
  vpEdgeCue cue(single(5));
  double sum = 0.;
  double squares = 0.;
  unsigned int seed = 1;
  const std::vector<Line> edges = edgesAllAround(12);
  for (const Line &edge : edges) {
    vpImage<unsigned char> I = drawStep(edge, 100., sigma);
    addNoise(I, noise, seed++);
    match(cue, I, viewOf({edge.moved(1.3)}));
    const Deviation deviation = deviationFrom(edge, cue);
    sum += deviation.mean;
    squares += deviation.rms * deviation.rms;
  }
  INFO("noise " << noise << " sigma " << sigma);
  CHECK(std::sqrt(squares / static_cast<double>(edges.size())) < 0.2);
  CHECK(std::fabs(sum / static_cast<double>(edges.size())) < 0.05);
}

TEST_CASE("offsets and contrasts have the sign of the point's normal", "[edge-search]")
{
  const double step = GENERATE(100., -60.);
  vpEdgeCue cue(single(5));
  for (const Line &edge : edgesAllAround(8)) {
    match(cue, drawStep(edge, step), viewOf({edge.moved(2.)}));
    REQUIRE(found(cue) == cue.matches().size());
    for (const vpEdgeCue::Match &match : cue.matches()) {
      const vpEdgeCue::Candidate &candidate = cue.candidates()[static_cast<std::size_t>(match.first)];
      const double along = edge.normal().dot(match.point.normal);
      CHECK(candidate.offset == Approx(offsetTo(edge, match.point)).margin(0.15));
      CHECK(candidate.contrast == Approx(along * step).epsilon(0.1));
    }
  }
}

TEST_CASE("along the axes the contrast is the height of the step", "[edge-search]")
{
  const unsigned int maskSize = GENERATE(3U, 5U, 7U);
  vpEdgeCue cue(single(maskSize));
  for (const double angle : {0., M_PI / 2.}) {
    const Line edge{Eigen::Vector2d(80.5, 60.5), angle};
    match(cue, drawStep(edge, 80.), viewOf({edge.moved(1.)}));
    REQUIRE(found(cue) == cue.matches().size());
    for (const vpEdgeCue::Candidate &candidate : cue.candidates()) {
      CHECK(std::fabs(candidate.contrast) == Approx(80.).margin(1.));
    }
  }
}

TEST_CASE("a candidate's place is the pixel in normalised coordinates", "[edge-search]")
{
  const vpCameraParameters cam = makeCamera();
  const Line edge{Eigen::Vector2d(70., 66.), 0.8};
  vpEdgeCue cue(single(5));
  match(cue, drawStep(edge, 100., 1.), viewOf({edge.moved(-2.)}));
  for (const vpEdgeCue::Match &match : cue.matches()) {
    const vpEdgeCue::Candidate &candidate = cue.candidates()[static_cast<std::size_t>(match.first)];
    const Eigen::Vector2d pixel(cam.get_u0() + cam.get_px() * candidate.place.x(),
                                cam.get_v0() + cam.get_py() * candidate.place.y());
    CHECK((pixel - match.point.pixel - candidate.offset * match.point.normal).norm() < 1e-9);
  }
}

TEST_CASE("an even mask works as the next smaller odd one", "[edge-search]")
{
  const Line edge{Eigen::Vector2d(80.2, 60.1), 0.3};
  const vpImage<unsigned char> I = drawStep(edge, 100., 1.);
  const vpModelView view = viewOf({edge});
  vpEdgeCue even(single(6));
  vpEdgeCue odd(single(5));
  match(even, I, view);
  match(odd, I, view);
  REQUIRE(even.candidates().size() == odd.candidates().size());
  for (std::size_t i = 0; i < odd.candidates().size(); ++i) {
    CHECK(even.candidates()[i].offset == exactly(odd.candidates()[i].offset));
  }
}

TEST_CASE("the largest mask and range that settings allow are searched", "[edge-search]")
{
  vpEdgeCueSettings settings = single(15);
  settings.range = 100.;
  vpEdgeCue cue(settings);
  const Line edge{Eigen::Vector2d(60., 200.3), 0.};
  const vpImage<unsigned char> I = draw(
      [&](const Eigen::Vector2d &pixel) { return 50. + 100. * blurredStep(edge.distance(pixel), 1.); }, width, 400);
  vpTrackedModelBuilder builder;
  const Line line = edge.moved(-95.);
  builder.addLine(backProject(line.through), backProject(line.through + 40. * line.direction()));
  vpModelView view(std::make_shared<const vpTrackedModel>(builder.build("line")));
  view.compute(vpHomogeneousMatrix(), makeCamera(), width, 400, vpModelViewOptions(), nullptr);
  match(cue, I, view);
  REQUIRE(found(cue) == view.points().size());
  CHECK(deviationFrom(edge, cue).largest < 0.1);
}
