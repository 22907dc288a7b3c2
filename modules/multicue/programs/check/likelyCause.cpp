// SPDX-License-Identifier: GPL-2.0-or-later
#include "check/likelyCause.h"

#include "check/checkReport.h"

namespace programs {
namespace {
// Of vpMbMultiCueTracker::score(): above what is enough for one pose, as the best of some dozens is looked at.
constexpr double isSeen = 0.7;

struct Guess
{
  double score = isSeen;
  std::string text;

  void offer(double other, const std::string &reason)
  {
    if (other > score) {
      score = other;
      text = reason;
    }
  }
};

// A model that is s times as large looks the same at s times the distance.
void guessUnits(const vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
                Guess &guess)
{
  for (const double factor : {1000., 100., 39.37, 10., 2.54, 0.1, 0.0254, 0.01, 0.001}) {
    vpHomogeneousMatrix other = cMo;
    for (unsigned int i = 0; i < 3; ++i) {
      other[i][3] /= factor;
    }
    guess.offer(tracker.score(I, other),
                printed("the unit is wrong: the image shows a model that is %g times as large", factor) +
                    ", or a pose whose translation is divided by that; give --unit, and poses in "
                    "metres");
  }
}

void guessPoses(const vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
                Guess &guess)
{
  constexpr double right = 1.5707963267948966, half = 2. * right;
  guess.offer(tracker.score(I, cMo.inverse()), "the pose is inverted: give that of the object in the camera's frame");
  guess.offer(tracker.score(I, vpHomogeneousMatrix(0., 0., 0., half, 0., 0.) * cMo),
              "the pose has OpenGL's axes: y and z of the camera's frame are to point down and forward");
  const struct
  {
    vpHomogeneousMatrix turn;
    const char *name;
  } turns[] = {{vpHomogeneousMatrix(0., 0., 0., right, 0., 0.), "90 degrees about its x axis"},
               {vpHomogeneousMatrix(0., 0., 0., -right, 0., 0.), "-90 degrees about its x axis"},
               {vpHomogeneousMatrix(0., 0., 0., half, 0., 0.), "180 degrees about its x axis"},
               {vpHomogeneousMatrix(0., 0., 0., 0., right, 0.), "90 degrees about its y axis"},
               {vpHomogeneousMatrix(0., 0., 0., 0., -right, 0.), "-90 degrees about its y axis"},
               {vpHomogeneousMatrix(0., 0., 0., 0., half, 0.), "180 degrees about its y axis"},
               {vpHomogeneousMatrix(0., 0., 0., 0., 0., right), "90 degrees about its z axis"},
               {vpHomogeneousMatrix(0., 0., 0., 0., 0., -right), "-90 degrees about its z axis"},
               {vpHomogeneousMatrix(0., 0., 0., 0., 0., half), "180 degrees about its z axis"}};
  for (const auto &one : turns) {
    guess.offer(tracker.score(I, cMo * one.turn),
                std::string("the model's axes are others: the image shows it turned by ") + one.name +
                    "; export it with the axes that the pose is for");
  }
}

// With another camera for the time of this call.
double scoreWith(const vpCameraParameters &cam, vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I,
                 const vpHomogeneousMatrix &cMo)
{
  vpCameraParameters before;
  tracker.getCameraParameters(before);
  tracker.setCameraParameters(cam);
  const double score = tracker.score(I, cMo);
  tracker.setCameraParameters(before);
  return score;
}

void guessCameras(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, Guess &guess)
{
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  for (const double factor : {0.25, 0.5, 2. / 3., 0.75, 4. / 3., 1.5, 2., 4.}) {
    const vpCameraParameters focal(factor * cam.get_px(), factor * cam.get_py(), cam.get_u0(), cam.get_v0());
    const vpCameraParameters resized(factor * cam.get_px(), factor * cam.get_py(), factor * (cam.get_u0() + 0.5) - 0.5,
                                     factor * (cam.get_v0() + 0.5) - 0.5);
    const std::string text =
        printed("the camera is another one: the image was taken with %.2f times the focal length", factor);
    guess.offer(scoreWith(focal, tracker, I, cMo), text + "; calibrate it");
    guess.offer(scoreWith(resized, tracker, I, cMo), text + ", as that of images of another size");
  }
}

// A mirrored model in an image looks as the model does in the mirrored image.
void guessMirror(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, Guess &guess)
{
  vpImage<vpRGBa> mirrored(I.getHeight(), I.getWidth());
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 0; j < I.getWidth(); ++j) {
      mirrored[i][j] = I[i][I.getWidth() - 1 - j];
    }
  }
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  const vpCameraParameters other(cam.get_px(), cam.get_py(), I.getWidth() - 1. - cam.get_u0(), cam.get_v0());
  for (unsigned int axis = 0; axis < 3; ++axis) {
    vpHomogeneousMatrix pose = cMo;
    for (unsigned int k = 0; k < 4; ++k) {
      pose[0][k] = -pose[0][k];
    }
    for (unsigned int k = 0; k < 3; ++k) {
      pose[k][axis] = -pose[k][axis];
    }
    guess.offer(scoreWith(other, tracker, mirrored, pose),
                std::string("the mesh is mirrored: the image shows it with its ") + "xyz"[axis] +
                    " axis the other way round; export it anew");
  }
}
} // namespace

std::string likelyCause(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo)
{
  Guess guess;
  guessUnits(tracker, I, cMo, guess);
  guessPoses(tracker, I, cMo, guess);
  guessMirror(tracker, I, cMo, guess);
  guessCameras(tracker, I, cMo, guess);
  return guess.text;
}

} // namespace programs
