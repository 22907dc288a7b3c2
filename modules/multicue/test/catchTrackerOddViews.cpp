// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpPixelMeterConversion.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>
#include <limits>

/*
  Views at the limits of what a camera shows. Where the object can be followed it has to be; elsewhere any state will do
  that has a pose that can be and a reason.
*/
namespace {
using modelShapes::Point;

struct View
{
  std::string name;
  std::string model; //!< Path.
  vpCameraParameters camera;
  vpHomogeneousMatrix cMo;
  unsigned int width = 320;
  unsigned int height = 240;
  bool isFollowed = true;
};

vpCameraParameters pinhole(double px, double py, double u0, double v0)
{
  return vpCameraParameters(px, py, u0, v0);
}

vpCameraParameters distorting(double kud, double kdu)
{
  vpCameraParameters cam;
  cam.initPersProjWithDistortion(400., 400., 159.5, 119.5, kud, kdu);
  return cam;
}

std::string boxFile(const Point &size)
{
  static int count = 0;
  const std::string file = meshFiles::temporaryFile("odd-view-" + std::to_string(++count) + ".stl");
  std::ofstream(file) << meshFiles::asciiStl(modelShapes::boxTriangles(size));
  return file;
}

std::string caoFile(const std::string &faces)
{
  static int count = 0;
  const std::string file = meshFiles::temporaryFile("odd-view-" + std::to_string(++count) + ".cao");
  std::ofstream(file) << "V1\n5\n-.06 -.04 0\n.06 -.04 0\n.06 .04 0\n-.06 .04 0\n-.06 -.04 0\n" << faces;
  return file;
}

//! As a camera with this distortion sees it; sides have gray levels of their own.
vpImage<vpRGBa> draw(vpMbMultiCueTracker &tracker, const View &view, const vpHomogeneousMatrix &cMo)
{
  const std::shared_ptr<const vpTrackedModel> model = tracker.getModel();
  const vpCameraParameters &cam = view.camera;
  vpRenderOptions options;
  options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL;
  vpRenderedView rendered;
  vpCpuRenderer(model).render(cMo, pinhole(cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0()), view.width,
                              view.height, options, rendered);
  vpImage<vpRGBa> I(view.height, view.width, vpRGBa(50, 90, 70));
  for (unsigned int i = 0; i < view.height; ++i) {
    for (unsigned int j = 0; j < view.width; ++j) {
      double x = 0.;
      double y = 0.;
      vpPixelMeterConversion::convertPoint(cam, j, i, x, y);
      const int at = rendered.index(x * cam.get_px() + cam.get_u0(), y * cam.get_py() + cam.get_v0());
      if (at >= 0 && rendered.depth[static_cast<std::size_t>(at)] > 0.F) {
        const float slope = rendered.normal[static_cast<std::size_t>(at)].z();
        I[i][j] = vpRGBa(static_cast<unsigned char>(230.F - 100.F * slope * slope), 60, 40);
      }
    }
  }
  return I;
}

bool isFinite(const vpHomogeneousMatrix &cMo)
{
  return std::all_of(cMo.data, cMo.data + 16, [](double x) { return std::isfinite(x); });
}

void check(const View &view, bool hasAllCues)
{
  CAPTURE(view.name, hasAllCues);
  vpMbMultiCueTracker tracker;
  tracker.setFrameDeadline(0.);
  if (!hasAllCues) {
    tracker.setPreset(vpMultiCuePreset::FAST);
  }
  tracker.setCameraParameters(view.camera);
  tracker.loadModel(view.model);
  tracker.initFromPose(draw(tracker, view, view.cMo), view.cMo);
  for (int i = 1; i <= 5; ++i) {
    const vpHomogeneousMatrix cMo =
        view.cMo * vpHomogeneousMatrix(0.001 * i, 0.001 * i, 0., 0.002 * i, -0.002 * i, 0.004 * i);
    CHECK_NOTHROW(tracker.track(draw(tracker, view, cMo)));
    const vpMbTrackingResult result = tracker.getTrackingResult();
    CHECK(isFinite(result.cMo));
    CHECK(!result.text.empty());
    CHECK((result.score >= 0. && result.score <= 1.));
    if (view.isFollowed) {
      const double depth = view.cMo[2][3];
      CHECK(result.state != vpTrackingState::LOST);
      CHECK((result.cMo.getTranslationVector() - cMo.getTranslationVector()).frobeniusNorm() < 0.03 * depth);
    }
  }
}

vpHomogeneousMatrix oblique(double depth)
{
  return vpHomogeneousMatrix(0., 0., depth, 0.8, 0.4, 0.2);
}

std::vector<View> oddViews()
{
  const std::string box = boxFile(Point(0.12, 0.08, 0.06));
  const std::string sheet = caoFile("0\n0\n1\n4 0 1 2 3\n0\n0\n");
  const vpCameraParameters usual = pinhole(400., 400., 159.5, 119.5);
  std::vector<View> views = {
      {"one face", box, usual, vpHomogeneousMatrix(0., 0., 0.4, 0., 0., 0.3)},
      {"other focal lengths", box, pinhole(400., 240., 159.5, 119.5), oblique(0.4)},
      {"principal point outside", box, pinhole(400., 400., -60., 300.),
       vpHomogeneousMatrix(0.22, -0.18, 0.4, 0.8, 0.4, 0.2)},
      {"strong distortion", box, distorting(-0.35, 0.45), oblique(0.4)},
      {"16 pixels", box, usual, oblique(3.)},
      {"4K", box, pinhole(4800., 4800., 1919.5, 1079.5), oblique(0.4), 3840, 2160},
      {"image filled", box, usual, oblique(0.12)},
      {"camera inside", box, usual, vpHomogeneousMatrix(0., 0., 0.01, 0., 0., 0.)},
      {"leaving", box, usual, vpHomogeneousMatrix(0.19, 0., 0.4, 0.8, 0.4, 0.2)},
      {"sheet edge-on", sheet, usual, vpHomogeneousMatrix(0., 0., 0.4, M_PI / 2., 0., 0.)},
      {"lines end-on", boxFile(Point(0.02, 0.02, 0.6)), usual, vpHomogeneousMatrix(0., 0., 0.5, 0., 0., 0.)},
      {"a line end-on", caoFile("1\n0 1\n0\n0\n0\n0\n"), usual, vpHomogeneousMatrix(0., 0.04, 0.4, 0., M_PI / 2., 0.)},
      {"points twice", caoFile("0\n0\n1\n5 0 4 1 2 3\n0\n0\n"), usual, vpHomogeneousMatrix(0., 0., 0.4, 0.5, 0., 0.3)},
      {"2 pixels", box, usual, oblique(25.)}};
  for (View &view : views) {
    static const std::vector<std::string> followed = {"one face", "other focal lengths", "principal point outside",
                                                      "strong distortion", "4K"};
    view.isFollowed = std::find(followed.begin(), followed.end(), view.name) != followed.end();
  }
  return views;
}
} // namespace

TEST_CASE("Views at the limits give poses that can be, and those that show the object are followed", "[odd-views]")
{
  for (const View &view : oddViews()) {
    check(view, false);
    check(view, true);
  }
}

TEST_CASE("No control point, or one, gives a pose that can be", "[odd-views]")
{
  const View view = {"far", boxFile(Point(0.12, 0.08, 0.06)), pinhole(400., 400., 159.5, 119.5), oblique(0.4)};
  for (const double step : {200., 1000., 1e6}) {
    CAPTURE(step);
    vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
    tracker.setCameraParameters(view.camera);
    tracker.loadModel(view.model);
    vpMe me = tracker.getMovingEdge();
    me.setSampleStep(step);
    tracker.setMovingEdge(me);
    tracker.initFromPose(draw(tracker, view, view.cMo), view.cMo);
    for (int i = 0; i < 3; ++i) {
      CHECK_NOTHROW(tracker.track(draw(tracker, view, view.cMo)));
      CHECK(isFinite(tracker.getPose()));
      CHECK(!tracker.getTrackingResult().text.empty());
    }
  }
}

TEST_CASE("A camera whose numbers are none is refused, and the object is followed on", "[odd-views]")
{
  const View view = {"box", boxFile(Point(0.12, 0.08, 0.06)), pinhole(400., 400., 159.5, 119.5), oblique(0.4)};
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.setCameraParameters(view.camera);
  tracker.loadModel(view.model);
  const vpImage<vpRGBa> I = draw(tracker, view, view.cMo);
  tracker.initFromPose(I, view.cMo);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(tracker.setCameraParameters(pinhole(nan, 400., 159.5, 119.5)), vpException);
  CHECK_THROWS_AS(tracker.setCameraParameters(pinhole(0., 400., 159.5, 119.5)), vpException);
  CHECK_THROWS_AS(tracker.setCameraParameters(pinhole(400., 400., HUGE_VAL, 119.5)), vpException);
  CHECK_THROWS_AS(tracker.setCameraParameters(distorting(nan, 0.)), vpException);
  CHECK_THROWS_AS(tracker.setCameraParameters(distorting(0., HUGE_VAL)), vpException);
  tracker.track(I);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
}
