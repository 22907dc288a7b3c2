// SPDX-License-Identifier: GPL-2.0-or-later
#include "edgeScenes.h"

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <limits>
#include <string>

using namespace edgeScenes;

namespace {
const Line slanted{Eigen::Vector2d(50.3, 40.8), 0.5};

vpCameraParameters withDistortion(double kud)
{
  vpCameraParameters cam;
  cam.initPersProjWithDistortion(150., 150., 80., 60., kud, -kud);
  return cam;
}

vpCameraParameters fisheye()
{
  vpCameraParameters cam;
  cam.initProjWithKannalaBrandtDistortion(150., 150., 80., 60., {-0.1, 0.02, -0.01, 0.003});
  return cam;
}

vpCameraParameters withoutDistortion(const vpCameraParameters &cam)
{
  return vpCameraParameters(cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
}

// Factor by which a lens moves a point at distance r from the axis.
double stretch(const vpCameraParameters &cam, double r)
{
  if (cam.get_projModel() == vpCameraParameters::perspectiveProjWithDistortion) {
    return 1. + cam.get_kud() * r * r;
  }
  const std::vector<double> k = cam.getKannalaBrandtDistortionCoefficients();
  const double theta = std::atan(r);
  const double square = theta * theta;
  const double thetaD = theta * (1. + square * (k[0] + square * (k[1] + square * (k[2] + square * k[3]))));
  return r > 0. ? thetaD / r : 1.;
}

// Where a camera without distortion would see what is at \e pixel of the image that was taken.
Eigen::Vector2d undistorted(const vpCameraParameters &cam, const Eigen::Vector2d &pixel)
{
  const Eigen::Vector2d centre(cam.get_u0(), cam.get_v0());
  const Eigen::Vector2d taken = (pixel - centre) / cam.get_px();
  Eigen::Vector2d straight = taken;
  for (int i = 0; i < 12; ++i) {
    straight = taken / stretch(cam, straight.norm());
  }
  return centre + cam.get_px() * straight;
}

// True where both the image that was taken and the undistorted one have all of a mask around \e pixel of the latter.
bool isWellInside(const vpCameraParameters &cam, const Eigen::Vector2d &pixel)
{
  const Eigen::Vector2d centre(cam.get_u0(), cam.get_v0());
  const Eigen::Vector2d straight = pixel - centre;
  const auto inside = [&](double scale) {
    const Eigen::Vector2d p = centre + scale * straight;
    return p.x() > 5. && p.y() > 5. && p.x() < width - 6. && p.y() < height - 6.;
  };
  return inside(1.) && inside(stretch(cam, straight.norm() / cam.get_px()));
}

vpImage<unsigned char> drawThrough(const vpCameraParameters &cam, const Line &line)
{
  return draw([&](const Eigen::Vector2d &pixel) {
    return 60. + 120. * blurredStep(line.distance(undistorted(cam, pixel)), 0.7);
  });
}

vpModelView viewThrough(const vpCameraParameters &cam, const Line &line)
{
  vpTrackedModelBuilder builder;
  const auto at = [&](double along) {
    const Eigen::Vector2d pixel = line.through + along * line.direction();
    return Eigen::Vector3d((pixel.x() - cam.get_u0()) / cam.get_px(), (pixel.y() - cam.get_v0()) / cam.get_py(), 1.);
  };
  builder.addLine(at(-200.), at(200.));
  vpModelView view(std::make_shared<const vpTrackedModel>(builder.build("line")));
  view.compute(vpHomogeneousMatrix(), cam, width, height, vpModelViewOptions(), nullptr);
  return view;
}

vpImage<vpRGBa> toColor(const vpImage<unsigned char> &I)
{
  vpImage<vpRGBa> color(I.getHeight(), I.getWidth());
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    color.bitmap[i] = vpRGBa(I.bitmap[i], I.bitmap[i], I.bitmap[i]);
  }
  return color;
}
} // namespace

TEST_CASE("edges are where a camera without distortion would see them", "[cue-frame]")
{
  const vpCameraParameters cam = GENERATE(withDistortion(-0.3), withDistortion(0.25), fisheye());
  const vpModelView view = viewThrough(cam, slanted.moved(1.5));
  const vpImage<unsigned char> I = drawThrough(cam, slanted);
  vpFrameSource source;
  vpEdgeCue cue;
  const auto checkMatches = [&]() {
    REQUIRE(cue.matches().size() > 20);
    for (const vpEdgeCue::Match &match : cue.matches()) {
      if (!isWellInside(cam, match.point.pixel)) {
        continue;
      }
      REQUIRE(match.count == 1);
      const double offset = cue.candidates()[static_cast<std::size_t>(match.first)].offset;
      CHECK(offset == Approx(offsetTo(slanted, match.point)).margin(0.1));
    }
  };
  const vpCueFrame frame = source.frame(I, cam, nullptr);
  CHECK(frame.camera() == withoutDistortion(cam));
  CHECK(frame.width() == width);
  CHECK(frame.height() == height);
  CHECK_FALSE(frame.hasColor());
  cue.match(frame, view);
  checkMatches();
  const vpCueFrame colored = source.frame(toColor(I), cam, nullptr);
  CHECK(colored.hasColor());
  cue.match(colored, view);
  checkMatches();
}

TEST_CASE("where the lens saw nothing there is no edge", "[cue-frame]")
{
  const vpCameraParameters cam = withDistortion(0.5);
  vpFrameSource source;
  const vpImage<unsigned char> plain(height, width, 200);
  const vpCueFrame frame = source.frame(plain, cam, nullptr);
  CHECK(frame.isMasked(0., 0.));
  CHECK_FALSE(frame.isMasked(80., 60.));
  vpEdgeCueSettings settings;
  settings.range = 30.;
  vpEdgeCue cue(settings);
  for (const double angle : {0., M_PI / 2., 0.6}) {
    for (const double across : {-55., -40., 0., 40., 55.}) {
      cue.match(frame, viewThrough(cam, Line{Eigen::Vector2d(80., 60.), angle}.moved(across)));
      CHECK(found(cue) == 0);
    }
  }
  cue.match(source.frame(toColor(plain), cam, nullptr), viewThrough(cam, {Eigen::Vector2d(8., 60.), M_PI / 2.}));
  CHECK(found(cue) == 0);
}

TEST_CASE("a distortion of zero is none", "[cue-frame]")
{
  vpFrameSource source;
  const vpImage<unsigned char> I = drawStep(slanted, 100.);
  const vpCueFrame frame = source.frame(I, withDistortion(0.), nullptr);
  CHECK(&frame.gray() == &I);
  CHECK_FALSE(frame.isMasked(-5., 0.));
}

TEST_CASE("a source follows the camera and the size", "[cue-frame]")
{
  vpFrameSource source;
  for (const double kud : {0.2, -0.2, 0.}) {
    for (const unsigned int rows : {30U, 60U}) {
      const vpImage<unsigned char> I(rows, 40, 77);
      const vpCueFrame frame = source.frame(I, withDistortion(kud), nullptr);
      CHECK(frame.height() == rows);
      // Lens or not, a plain image stays plain up to the border.
      CHECK(std::equal(I.bitmap, I.bitmap + I.getSize(), frame.gray().bitmap));
    }
  }
}

TEST_CASE("every frame has a number of its own", "[cue-frame]")
{
  CHECK(vpCueFrame().number() == 0);
  vpFrameSource first;
  vpFrameSource second;
  const vpImage<unsigned char> I(30, 40, 77);
  const vpImage<vpRGBa> color(30, 40, vpRGBa(1, 2, 3));
  const unsigned long long a = first.frame(I, withDistortion(0.), nullptr).number();
  const unsigned long long b = second.frame(I, withDistortion(0.), nullptr).number();
  const unsigned long long c = first.frame(color, withDistortion(0.1), nullptr).number();
  CHECK(a > 0);
  CHECK(b > a);
  CHECK(c > b);
}

TEST_CASE("gray colours are gray levels", "[cue-frame]")
{
  vpFrameSource source;
  const vpImage<unsigned char> I = drawStep(slanted, 100., 1.);
  const vpImage<vpRGBa> color = toColor(I);
  const vpCueFrame frame = source.frame(color, makeCamera(), nullptr);
  REQUIRE(frame.hasColor());
  CHECK(&frame.color() == &color);
  vpEdgeCue cue;
  vpEdgeCue fromColor;
  const vpModelView view = viewOf({slanted});
  match(cue, I, view);
  fromColor.match(frame, view);
  REQUIRE(cue.candidates().size() == fromColor.candidates().size());
  for (std::size_t i = 0; i < cue.candidates().size(); ++i) {
    // ViSP's conversion may be off by one gray level.
    CHECK(cue.candidates()[i].offset == Approx(fromColor.candidates()[i].offset).margin(0.03));
  }
}

TEST_CASE("masked parts of the image are not used", "[cue-frame]")
{
  const Line edge{Eigen::Vector2d(80., 60.), M_PI / 2.};
  vpImage<bool> mask(height, width, true);
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 0; j < width; ++j) {
      mask[i][j] = j < 83;
    }
  }
  vpEdgeCue cue;
  SECTION("control points")
  {
    match(cue, drawStep(edge, 100.), viewOf({edge.moved(-5.)}), &mask); // In column 85.
    CHECK(cue.matches().empty());
    match(cue, drawStep(edge, 100.), viewOf({edge}), &mask);
    CHECK(found(cue) == viewOf({edge}).points().size());
  }
  SECTION("edges")
  {
    match(cue, drawStep(edge.moved(-6.), 100.), viewOf({edge}), &mask); // In column 86.
    CHECK(cue.matches().size() > 15);
    CHECK(inState(cue, vpFeatureState::THRESHOLD) == cue.matches().size());
    CHECK(cue.candidates().empty());
  }
  SECTION("a hidden edge does not take the place of one that is seen")
  {
    vpEdgeCueSettings settings;
    settings.candidates = 1;
    cue.setSettings(settings);
    const vpImage<unsigned char> I = draw([&](const Eigen::Vector2d &pixel) {
      return 30. + 40. * blurredStep(pixel.x() - 76., 0.5) + 150. * blurredStep(pixel.x() - 86., 0.5);
    });
    match(cue, I, viewOf({edge}), &mask);
    REQUIRE(found(cue) == cue.matches().size());
    for (const vpEdgeCue::Candidate &candidate : cue.candidates()) {
      CHECK(std::fabs(candidate.offset) == Approx(4.).margin(0.1));
    }
  }
}

TEST_CASE("a mask is given for the image as it was taken", "[cue-frame]")
{
  const vpCameraParameters cam = withDistortion(-0.3);
  vpImage<bool> mask(height, width, true);
  for (unsigned int i = 0; i < height; ++i) {
    mask[i][20] = false;
  }
  vpFrameSource source;
  const vpCueFrame frame = source.frame(vpImage<unsigned char>(height, width, 10), cam, &mask);
  CHECK(frame.hasMask());
  for (const double v : {30., 60., 80.}) {
    const Eigen::Vector2d hidden = undistorted(cam, Eigen::Vector2d(20., v));
    CHECK(hidden.x() < 19.);
    CHECK(frame.isMasked(hidden.x(), hidden.y()));
    CHECK_FALSE(frame.isMasked(hidden.x() - 2., hidden.y()));
    CHECK_FALSE(frame.isMasked(20.5, v));
  }
}

TEST_CASE("bad input is refused with a reason", "[cue-frame]")
{
  vpFrameSource source;
  const vpImage<unsigned char> I(height, width, 0);
  const vpImage<bool> small(10, 20, true);
  const auto take = [&](const vpCameraParameters &cam) { source.frame(I, cam, nullptr); };
  CHECK_THROWS_WITH(source.frame(I, makeCamera(), &small),
                    ContainsSubstring("20 x 10") && ContainsSubstring("160 x 120"));
  CHECK_THROWS_WITH(source.frame(vpImage<unsigned char>(), makeCamera(), nullptr), ContainsSubstring("empty"));
  CHECK_THROWS_WITH(source.frame(vpImage<vpRGBa>(), makeCamera(), nullptr), ContainsSubstring("0 x 0"));
  CHECK_THROWS_WITH(take(vpCameraParameters(-5., 600., 80., 60.)), ContainsSubstring("px -5"));
  CHECK_THROWS_WITH(take(withDistortion(std::numeric_limits<double>::quiet_NaN())), ContainsSubstring("kud is nan"));
  vpCameraParameters cam;
  cam.initProjWithKannalaBrandtDistortion(150., 150., 80., 60., {0.1});
  CHECK_THROWS_WITH(take(cam), ContainsSubstring("1 Kannala-Brandt"));
}
