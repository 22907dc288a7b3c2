// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef recoveryScene_h
#define recoveryScene_h

#include <catchMain.h>

#include "searchScenes.h"

#include <meshFiles.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>

/*! \file recoveryScene.h A tracker of a box that is lost, and what becomes of it where the box is shown again. */

BEGIN_VISP_NAMESPACE
namespace recoveryScene {
using colorScenes::Scene;
using searchScenes::displaced;

inline const Eigen::Vector3d boxSize(0.2, 0.14, 0.1);
inline const vpHomogeneousMatrix start = searchScenes::truePose();

inline vpImage<vpRGBa> plainImage(const vpRGBa &color)
{
  return vpImage<vpRGBa>(colorScenes::height, colorScenes::width, color);
}

inline const vpRGBa black(0, 0, 0);

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

inline vpHomogeneousMatrix elsewhere(double degrees)
{
  return displaced(start, {1., 0.2, 0.3}, degrees, {-0.12, 0.06, 0.});
}

inline vpHomogeneousMatrix turned(double degrees)
{
  return displaced(Tracked::swaying(12), {0.2, 1., 0.3}, degrees, Eigen::Vector3d::Zero());
}

inline void checkReturn(const Tracked::Return &found)
{
  CHECK(found.right <= 10);
  CHECK(found.confirmed > 1); // Not at the first look.
  CHECK(found.confirmed <= 13);
  CHECK(found.wronglyTracked == 0);
}
} // namespace recoveryScene
END_VISP_NAMESPACE
#endif
