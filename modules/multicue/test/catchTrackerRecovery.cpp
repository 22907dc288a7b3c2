// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "searchScenes.h"

#include <meshFiles.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {
using colorScenes::Scene;
using searchScenes::displaced;

const Eigen::Vector3d boxSize(0.2, 0.14, 0.1);
const vpHomogeneousMatrix start = searchScenes::truePose();

vpImage<vpRGBa> plainImage(const vpRGBa &color)
{
  return vpImage<vpRGBa>(colorScenes::height, colorScenes::width, color);
}

const vpRGBa black(0, 0, 0);

//! A tracker of a printed box before a cluttered background, and what it said of the last frame.
struct Tracked
{
  static constexpr int edgesAndPoints = vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::KLT_TRACKER;

  explicit Tracked(bool searches, int type = edgesAndPoints | vpMbMultiCueTracker::COLOR_TRACKER,
                   bool hasParticles = false)
      : isSearching(searches)
  {
    vpParticleSettings particles;
    particles.enabled = hasParticles;
    if (type == vpMbMultiCueTracker::EDGE_TRACKER) {
      paint = searchScenes::plainPaint();
    }
    tracker.setParticleSettings(particles);
    tracker.setTrackerType(type);
    tracker.setCameraParameters(colorScenes::makeCamera());
    tracker.loadModel(searchScenes::writeBox(boxSize, meshFiles::temporaryFile("recovery-box.obj")));
    tracker.setPrediction(true);
    tracker.setSearch(searches);
    tracker.initFromPose(scene.draw(start, paint), start);
    for (int i = 1; i <= 12; ++i) { // Until it knows what the object looks like.
      show(swaying(i));
      REQUIRE(isTracking());
      REQUIRE(isRight(swaying(i)));
    }
  }

  //! Turns to and fro about where it starts.
  static vpHomogeneousMatrix swaying(int i)
  {
    return displaced(start, {0.3, 1., 0.}, 6. * std::sin(0.5 * i), {0.002 * i, 0., 0.});
  }

  void show(const vpHomogeneousMatrix &cMo)
  {
    vpImage<vpRGBa> I = scene.draw(cMo, paint);
    for (unsigned int i = 0; i < likeness.getSize(); ++i) {
      if (I.bitmap[i] == background.bitmap[i]) {
        I.bitmap[i] = likeness.bitmap[i];
      }
    }
    tracker.track(I);
  }
  //! Where it is now, the lower right part of an unprinted box is shown from now on, behind all others.
  void leaveLikeness()
  {
    background = scene.draw(vpHomogeneousMatrix(9., 0., 1., 0., 0., 0.), paint); // The box is outside.
    colorScenes::Paint unprinted = paint;
    unprinted.object = [](const Eigen::Vector3d &) { return colorScenes::Color(120., 110., 90.); };
    likeness = scene.draw(tracker.getPose(), unprinted);
    for (unsigned int i = 0; i < likeness.getHeight(); ++i) {
      for (unsigned int j = 0; i + j < likeness.getWidth(); ++j) {
        likeness[i][j] = background[i][j];
      }
    }
  }
  bool isTracking() const { return tracker.getTrackingState() == vpTrackingState::TRACKING; }
  bool isFinite() const
  {
    const vpHomogeneousMatrix cMo = tracker.getPose();
    return std::all_of(cMo.data, cMo.data + 16, [](double value) { return std::isfinite(value); });
  }
  bool isRight(const vpHomogeneousMatrix &truth) const
  {
    const searchScenes::Difference d = searchScenes::differenceOf(tracker.getPose(), truth, *tracker.getModel());
    return d.degrees < 10. && d.diameters < 0.1;
  }

  //! Out of the image to the right, and away for some frames. \return Frames of the latter that are called TRACKING.
  int leave()
  {
    for (int i = 1; i <= 8; ++i) {
      show(displaced(swaying(12), Eigen::Vector3d::UnitX(), 0., {0.05 * i, 0., 0.}));
    }
    vpHomogeneousMatrix away = start;
    away[0][3] = 2.;
    int tracking = 0;
    for (int i = 0; i < 4; ++i) {
      show(away);
      tracking += isTracking();
    }
    return tracking;
  }

  //! The image is black for ten frames. \return Frames that are called TRACKING.
  int darken()
  {
    int tracking = 0;
    for (int i = 0; i < 10; ++i) {
      tracker.track(plainImage(black));
      tracking += isTracking();
    }
    return tracking;
  }

  //! Turns evenly about an axis of its own, in the dark after some frames. \return True where the second frame after it
  //! has the right pose.
  bool turnInTheDark(const Eigen::Vector3d &axis, double degreesPerFrame)
  {
    const auto at = [&](int i) { return displaced(swaying(12), axis, degreesPerFrame * i, {0.001 * i, 0., 0.}); };
    for (int i = 1; i <= 25; ++i) {
      tracker.track(i > 8 && i < 24 ? plainImage(black) : scene.draw(at(i)));
    }
    return isRight(at(25));
  }

  //! What becomes of it where it is shown at a pose again, and moves a bit.
  static constexpr int never = 99;
  struct Return
  {
    int right = never;      //!< First frame with the right pose, which all that follow have as well.
    int confirmed = never;  //!< First frame that is called TRACKING.
    int wronglyTracked = 0; //!< Frames that are called TRACKING with a wrong pose.
  };
  Return comeBack(const vpHomogeneousMatrix &cMo, int frames)
  {
    Return result;
    for (int i = 1; i <= frames; ++i) {
      const vpHomogeneousMatrix truth = displaced(cMo, Eigen::Vector3d::UnitZ(), 0.5 * i, {0.001 * i, 0., 0.});
      show(truth);
      CHECK((!isTracking() || !isSearching || tracker.getTrackingResult().score >= 0.85)); // Else it is not believed.
      result.right = !isRight(truth) ? never : std::min(result.right, i);
      result.confirmed = isTracking() ? std::min(result.confirmed, i) : result.confirmed;
      result.wronglyTracked += isTracking() && !isRight(truth);
    }
    return result;
  }

  bool isSearching;
  Scene scene{colorScenes::makeBox()};
  colorScenes::Paint paint;
  vpImage<vpRGBa> background;
  vpImage<vpRGBa> likeness; // Empty where there is none.
  vpMbMultiCueTracker tracker;
};

vpHomogeneousMatrix elsewhere(double degrees)
{
  return displaced(start, {1., 0.2, 0.3}, degrees, {-0.12, 0.06, 0.});
}

vpHomogeneousMatrix turned(double degrees)
{
  return displaced(Tracked::swaying(12), {0.2, 1., 0.3}, degrees, Eigen::Vector3d::Zero());
}

void checkReturn(const Tracked::Return &found)
{
  CHECK(found.right <= 10);
  CHECK(found.confirmed > 1); // Not at the first look.
  CHECK(found.confirmed <= 13);
  CHECK(found.wronglyTracked == 0);
}

vpImage<vpRGBa> noise(std::uint64_t seed)
{
  vpPoseRandom random(seed);
  vpImage<vpRGBa> I = plainImage(black);
  const auto level = [&random] { return static_cast<unsigned char>(255. * random.uniform()); };
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    I.bitmap[i].R = level();
    I.bitmap[i].G = level();
    I.bitmap[i].B = level();
  }
  return I;
}
} // namespace

TEST_CASE("Without colours, what was seen of the surface tells of jumps that turn the image by 50 degrees",
          "[recovery]")
{
  const vpHomogeneousMatrix before = Tracked::swaying(12);
  int right = 0;
  for (const double sign : {-1., 1.}) {
    for (const double shift : {-0.03, 0., 0.03}) {
      Tracked box(true, Tracked::edgesAndPoints);
      Eigen::Isometry3d pose = vpPoseExponential::toEigen(before);
      pose.linear() = Eigen::AngleAxisd(sign * 50. * M_PI / 180., Eigen::Vector3d::UnitZ()) * pose.linear();
      pose.translation() += Eigen::Vector3d(shift, -shift, 0.);
      const vpHomogeneousMatrix jumped = vpPoseExponential::fromEigen(pose);
      box.show(jumped);
      right += box.isRight(jumped) ? 1 : 0;
    }
  }
  CHECK(right >= 5);
}

TEST_CASE("An object that left the image is found where it comes back, turned by 40 degrees", "[recovery]")
{
  Tracked object(true);
  CHECK(object.leave() == 0);
  checkReturn(object.comeBack(elsewhere(40.), 14));
  CHECK(object.isTracking());
}

TEST_CASE("An object that turned by 60 degrees in the dark is found", "[recovery]")
{
  Tracked object(true);
  CHECK(object.darken() == 0);
  checkReturn(object.comeBack(turned(-60.), 14));
  CHECK(object.isTracking());
}

TEST_CASE("An object that turns on in the dark is looked for where it turned to", "[recovery]")
{
  int found = 0;
  for (const double rate : {-6., 6.}) {
    for (const Eigen::Vector3d axis : {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()}) {
      found += Tracked(true).turnInTheDark(axis, rate);
    }
  }
  CHECK(found >= 3);
}

TEST_CASE("An object that comes back from another distance is found there", "[recovery]")
{
  for (const double depth : {-0.15, 0.25}) { // Of 0.6 metres.
    CAPTURE(depth);
    Tracked object(true);
    CHECK(object.leave() == 0);
    vpHomogeneousMatrix back = elsewhere(25.);
    back[2][3] += depth;
    checkReturn(object.comeBack(back, 14));
    CHECK(object.isTracking());
  }
}

TEST_CASE("A hint brings back an object at half and at twice its distance", "[recovery]")
{
  for (const double depth : {-0.3, 0.6}) {
    CAPTURE(depth);
    Tracked object(true);
    CHECK(object.leave() == 0);
    vpHomogeneousMatrix back = elsewhere(25.);
    back[2][3] += depth;
    object.tracker.setPoseHint(displaced(back, {1., 0., 0.}, 5., {0.005, 0., 0.}));
    checkReturn(object.comeBack(back, 14));
    CHECK(object.isTracking());
  }
}

TEST_CASE("An object that jumps away is found, with a part of its likeness left where it was", "[recovery]")
{
  for (const double degrees : {-30., 30.}) {
    for (const double shift : {0.1, 0.12, 0.14}) {
      CAPTURE(degrees, shift);
      Tracked object(true);
      object.leaveLikeness();
      const vpHomogeneousMatrix jumped =
          displaced(Tracked::swaying(12), Eigen::Vector3d::UnitZ(), degrees, {shift, 0., 0.});
      const Tracked::Return found = object.comeBack(jumped, 14);
      CHECK(found.right <= 7);
      CHECK(found.confirmed <= 12);
      CHECK(found.wronglyTracked == 0);
    }
  }
}

TEST_CASE("With edges alone it is found as well, with and without particles", "[recovery]")
{
  for (const bool hasParticles : {false, true}) {
    CAPTURE(hasParticles);
    Tracked object(true, vpMbMultiCueTracker::EDGE_TRACKER, hasParticles);
    CHECK(object.darken() == 0);
    const Tracked::Return found = object.comeBack(turned(-40.), 16);
    CHECK(found.right <= 10);
    CHECK(found.confirmed > 1);
    CHECK(found.confirmed <= 15); // Another pose of a plain box has nearly the same outline.
    CHECK(found.wronglyTracked == 0);
    CHECK(object.isTracking());
    CHECK(object.leave() == 0);
  }
}

TEST_CASE("With edges alone it is found at the first look, on the other side of the image", "[recovery]")
{
  int found = 0;
  for (const double degrees : {25., 40., 55., 70.}) {
    CAPTURE(degrees);
    Tracked object(true, vpMbMultiCueTracker::EDGE_TRACKER);
    for (int i = 1; i <= 3; ++i) {
      object.show(displaced(Tracked::swaying(12), Eigen::Vector3d::UnitX(), 0., {0.03 * i, 0., 0.}));
    }
    CHECK(object.darken() == 0);
    const Tracked::Return back = object.comeBack(displaced(start, {1., 0.2, 0.3}, degrees, {-0.15, 0.05, 0.}), 10);
    found += back.right == 1;
    CHECK(back.wronglyTracked == 0);
  }
  CHECK(found >= 3);
}

TEST_CASE("An object that is soon lost again is looked for where it was seen last", "[recovery]")
{
  Tracked object(true, Tracked::edgesAndPoints); // Colours would tell where it is.
  object.darken();
  checkReturn(object.comeBack(turned(-40.), 14));
  vpHomogeneousMatrix last;
  for (int i = 1; i <= 30; ++i) { // On from the last pose of comeBack(), out of reach of where it was before.
    last = displaced(turned(-40.), Eigen::Vector3d::UnitZ(), 7., {0.014 - 0.008 * i, 0.003 * i, 0.});
    object.show(last);
    CHECK(object.isTracking());
  }
  object.darken();
  checkReturn(object.comeBack(last, 14));
}

TEST_CASE("An object that is lost again at once is looked for where it was seen for some frames", "[recovery]")
{
  for (const double degrees : {-55., 55.}) {
    CAPTURE(degrees);
    Tracked object(true, Tracked::edgesAndPoints); // Colours would tell where it is.
    object.darken();
    const auto at = [&](int i) { // Away from where it was before, and on.
      return displaced(turned(degrees * (1. + 0.04 * i)), Eigen::Vector3d::UnitZ(), i, {0.003 * i, 0.003 * i, 0.});
    };
    int tracking = 0;
    int i = 0;
    for (; i < 30 && tracking < 6; ++i) {
      object.show(at(i));
      tracking += object.isTracking();
    }
    REQUIRE(tracking == 6);
    object.darken();
    checkReturn(object.comeBack(at(i + 12), 14));
  }
}

TEST_CASE("Lines like the edges of an object that was lost are not taken for it", "[recovery]")
{
  const colorScenes::Color board(150., 110., 70.);
  Tracked object(true);
  CHECK(object.darken() == 0);
  object.paint.background = [&](double, double) { return board; };
  object.paint.object = [&](const Eigen::Vector3d &X) {
    const Eigen::Vector3d toSides = 0.5 * boxSize - X.cwiseAbs();
    return (toSides.array() < 0.003).count() > 1 ? colorScenes::Color(10., 10., 10.) : board;
  };
  CHECK(object.comeBack(turned(180.), 40).confirmed == Tracked::never); // From a side that was not seen before.
}

TEST_CASE("Without a search it is not", "[recovery]")
{
  Tracked gone(false);
  gone.leave();
  CHECK(gone.comeBack(elsewhere(40.), 14).right == Tracked::never);
  Tracked dark(false);
  dark.darken();
  CHECK(dark.comeBack(turned(-60.), 14).right == Tracked::never);
}

TEST_CASE("Images that do not show the object are never called TRACKING", "[recovery]")
{
  Scene scene(colorScenes::makeBox());
  colorScenes::Paint glaring;
  glaring.gain = 12.;
  const vpImage<vpRGBa> overExposed = scene.draw(Tracked::swaying(12), glaring);
  const vpImage<vpRGBa> white = plainImage(vpRGBa(255, 255, 255));
  const std::vector<std::pair<std::string, std::function<vpImage<vpRGBa>(int)>>> kinds = {
      {"black", [](int) { return plainImage(black); }},
      {"white", [&](int) { return white; }},
      {"noise", [](int i) { return noise(static_cast<std::uint64_t>(i)); }},
      {"over-exposed", [&](int) { return overExposed; }}};
  for (const auto &kind : kinds) {
    CAPTURE(kind.first);
    Tracked object(true);
    for (int i = 0; i < 11; ++i) {
      CHECK_NOTHROW(object.tracker.track(kind.second(i)));
      CHECK(object.isFinite());
      CHECK((i < 10 || !object.isTracking()));
    }
  }
}

TEST_CASE("A frame that is repeated keeps its pose", "[recovery]")
{
  Tracked object(true);
  const vpImage<vpRGBa> I = object.scene.draw(Tracked::swaying(12));
  for (int i = 0; i < 12; ++i) {
    CHECK_NOTHROW(object.tracker.track(I));
    CHECK(object.isTracking());
    CHECK(object.isRight(Tracked::swaying(12)));
  }
}

TEST_CASE("The same images give the same bits while the object is searched for", "[recovery]")
{
  Tracked first(true);
  Tracked second(true);
  const vpImage<vpRGBa> dark = plainImage(black);
  for (int i = 0; i < 8; ++i) {
    const vpImage<vpRGBa> I = i < 3 ? dark : first.scene.draw(turned(60. - i));
    first.tracker.track(I);
    second.tracker.track(I);
    const vpHomogeneousMatrix a = first.tracker.getPose();
    const vpHomogeneousMatrix b = second.tracker.getPose();
    CHECK(std::equal(a.data, a.data + 16, b.data));
    CHECK(first.tracker.getTrackingState() == second.tracker.getTrackingState());
    CHECK(first.tracker.getTrackingResult().score == exactly(second.tracker.getTrackingResult().score));
  }
}

TEST_CASE("A pose that the edges hold is not lost where light turns the colours", "[recovery]")
{
  Tracked tracked(true);
  for (int i = 13; i <= 22; ++i) {
    const vpHomogeneousMatrix truth = Tracked::swaying(i);
    vpImage<vpRGBa> image = tracked.scene.draw(truth);
    std::for_each(image.bitmap, image.bitmap + image.getSize(), [](vpRGBa &pixel) {
      pixel = vpRGBa(static_cast<unsigned char>(255 - pixel.R), static_cast<unsigned char>(255 - pixel.G),
                     static_cast<unsigned char>(255 - pixel.B));
    });
    tracked.tracker.track(image);
    CHECK(tracked.tracker.getTrackingState() != vpTrackingState::LOST);
    CHECK(tracked.isRight(truth));
  }
}
