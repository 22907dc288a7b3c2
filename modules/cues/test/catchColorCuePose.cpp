// SPDX-License-Identifier: GPL-2.0-or-later
#include "colorScenes.h"

#include <catchMain.h>

using namespace colorScenes;

namespace {
vpHomogeneousMatrix start()
{
  return vpHomogeneousMatrix(0.01, -0.02, 0.5, 0.5, 0.6, 0.2);
}

// Off by about so many pixels, a bit of it by turning.
vpHomogeneousMatrix off(const vpHomogeneousMatrix &cMo, double pixels, double angle)
{
  const vpHomogeneousMatrix moved = shifted(cMo, pixels * std::cos(angle), pixels * std::sin(angle));
  const double turn = 0.002 * pixels;
  return moved * vpHomogeneousMatrix(0., 0., 0., turn * std::sin(angle), turn * std::cos(angle), turn);
}

double worstOff(vpColorCue &cue, Scene &scene, double pixels, bool color, const Paint &later = Paint())
{
  const vpImage<vpRGBa> first = scene.draw(start());
  vpImage<unsigned char> gray;
  vpFrameSource source;
  double worst = 0.;
  for (const double angle : {0.3, 1.9, 3.4, 5.}) {
    cue.reset();
    const vpHomogeneousMatrix truth = off(start(), pixels, angle);
    const vpImage<vpRGBa> I = scene.draw(truth, later);
    if (color) {
      learn(cue, scene, source.frame(first, makeCamera(), nullptr), start());
      worst = std::max(worst,
                       pixelsOff(scene, truth, estimate(cue, scene, source.frame(I, makeCamera(), nullptr), start())));
    } else {
      vpImageConvert::convert(first, gray);
      learn(cue, scene, source.frame(gray, makeCamera(), nullptr), start());
      vpImageConvert::convert(I, gray);
      worst = std::max(
          worst, pixelsOff(scene, truth, estimate(cue, scene, source.frame(gray, makeCamera(), nullptr), start())));
    }
  }
  return worst;
}
} // namespace

TEST_CASE("the paper's local statistics find a pose that is some pixels off", "[color-pose]")
{
  vpColorCueSettings settings;
  settings.scales.clear();
  settings.bands = {4., 2., 1.};
  settings.length = 10.;
  vpColorCue cue(settings);
  Paint plain;
  plain.background = [](double u, double v) { return Color(60. + 0.2 * u, 90. + 0.2 * v, 120.); };
  for (const bool isBox : {true, false}) {
    Scene scene(isBox ? makeBox() : makeLump());
    const vpHomogeneousMatrix truth = off(start(), 4., 0.8);
    const vpImage<vpRGBa> I = scene.draw(truth, plain);
    vpFrameSource source;
    cue.reset();
    const vpHomogeneousMatrix found = estimate(cue, scene, source.frame(I, makeCamera(), nullptr), start());
    INFO("box " << isBox << ": " << pixelsOff(scene, truth, start()) << " to " << pixelsOff(scene, truth, found));
    CHECK(pixelsOff(scene, truth, start()) > 3.);
    CHECK(pixelsOff(scene, truth, found) < 0.4);
  }
}

TEST_CASE("with the coarse stage the pose may be far off, before clutter", "[color-pose]")
{
  vpColorCue cue;
  Scene box(makeBox());
  CHECK(worstOff(cue, box, 5., true) < 0.4);
  CHECK(worstOff(cue, box, 25., true) < 0.4);
  Scene lump(makeLump());
  CHECK(worstOff(cue, lump, 25., true) < 1.);
}

TEST_CASE("gray images do as well where gray levels differ", "[color-pose]")
{
  vpColorCue cue;
  Scene scene(makeBox());
  CHECK(worstOff(cue, scene, 5., false) < 1.);
}

TEST_CASE("the light may change between two frames", "[color-pose]")
{
  vpColorCue cue;
  Scene scene(makeBox());
  Paint darker;
  darker.gain = 0.8;
  CHECK(worstOff(cue, scene, 12., true, darker) < 0.5);
  Paint brighter;
  brighter.gain = 1.2;
  CHECK(worstOff(cue, scene, 12., true, brighter) < 0.5);
}

TEST_CASE("the same images give the same numbers", "[color-pose]")
{
  Scene scene(makeBox());
  const vpImage<vpRGBa> I = scene.draw(off(start(), 8., 2.));
  vpFrameSource source;
  std::vector<vpHomogeneousMatrix> found;
  for (int k = 0; k < 2; ++k) {
    vpColorCue cue;
    learn(cue, scene, source.frame(I, makeCamera(), nullptr), off(start(), 8., 2.));
    found.push_back(estimate(cue, scene, source.frame(I, makeCamera(), nullptr), start()));
  }
  for (unsigned int i = 0; i < 16; ++i) {
    CHECK(found[0].data[i] == exactly(found[1].data[i]));
  }
}

TEST_CASE("evidence is high where the contour is, and low elsewhere", "[color-pose]")
{
  vpColorCue cue;
  Scene scene(makeBox());
  vpFrameSource source;
  const vpImage<vpRGBa> I = scene.draw(start());
  const vpCueFrame frame = source.frame(I, makeCamera(), nullptr);
  learn(cue, scene, frame, start());
  const auto evidence = [&](double pixels) {
    cue.setLevel(1);
    cue.match(frame, scene.look(off(start(), pixels, 0.8)));
    return cue.evidence();
  };
  CHECK(evidence(0.) > 0.8);
  CHECK(evidence(30.) < 0.4);
  cue.setLevel(cue.levels());
  cue.match(frame, scene.look(start()));
  CHECK(cue.evidenceAt(start()) > 0.8);
  CHECK(cue.evidenceAt(off(start(), 10., 0.8)) < 0.5);
}
