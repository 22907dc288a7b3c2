// SPDX-License-Identifier: GPL-2.0-or-later
#include "colorScenes.h"

#include <visp3/se3/vpPoseExponential.h>

#include <catchMain.h>

using namespace colorScenes;

namespace {
const vpHomogeneousMatrix truth(0.01, -0.02, 0.5, 0.5, 0.6, 0.2);

// Before a black sky, darker than noise; what is left of a column has light.
Paint night(double lit)
{
  Paint paint;
  paint.background = [](double, double) { return Color(-10., -10., -10.); };
  const vpCameraParameters cam = makeCamera();
  paint.object = [=](const Eigen::Vector3d &oX) {
    const Eigen::Vector3d cX = vpPoseExponential::toEigen(truth) * oX;
    return cam.get_u0() + cam.get_px() * cX.x() / cX.z() < lit ? printed(oX) : Color(-10., -10., -10.);
  };
  return paint;
}
} // namespace

TEST_CASE("Colours without light speak neither for a pose nor against it", "[color-light]")
{
  const bool isColor = GENERATE(true, false);
  Scene scene(makeBox());
  vpFrameSource source;
  vpImage<unsigned char> gray;
  const auto frameOf = [&](const vpImage<vpRGBa> &I) {
    vpImageConvert::convert(I, gray);
    return isColor ? source.frame(I, makeCamera(), nullptr) : source.frame(gray, makeCamera(), nullptr);
  };
  vpColorCue cue;
  const vpImage<vpRGBa> whole = scene.draw(truth, night(1e9));
  learn(cue, scene, frameOf(whole), truth);
  const double usual = cue.evidenceAt(truth);
  CHECK(usual > 0.5);

  const double middle = makeCamera().get_u0();
  const vpImage<vpRGBa> half = scene.draw(truth, night(middle));
  cue.setLevel(1); // A coarse one.
  cue.match(frameOf(half), scene.look(truth));
  std::size_t dark = 0;
  for (const vpColorCue::Line &line : cue.lines()) {
    if (line.pixel.x() > middle + 10.) {
      CHECK(line.light == exactly(0.));
      ++dark;
    }
  }
  CHECK(dark > 5);
  CHECK(dark + 5 < cue.lines().size());
  CHECK(cue.evidence() > 0.6 * usual);
  CHECK(cue.evidenceAt(truth) > 0.6 * usual);
}
