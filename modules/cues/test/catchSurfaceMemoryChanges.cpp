// SPDX-License-Identifier: GPL-2.0-or-later
#include "surfaceScenes.h"

#include <catchMain.h>

namespace {
using surfaceScenes::Color;
using surfaceScenes::halfTurn;
using surfaceScenes::patches;
using surfaceScenes::Remembered;
using surfaceScenes::truth;

//! Something speckled over the right 43 % of the object's image.
vpImage<vpRGBa> occluded(const vpImage<vpRGBa> &I)
{
  vpImage<vpRGBa> covered = I;
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    for (unsigned int j = 172; j < I.getWidth(); ++j) {
      const double level = 60. + 190. * colorScenes::hashed(static_cast<int>(i / 7), static_cast<int>(j / 7));
      covered[i][j] = vpRGBa(static_cast<unsigned char>(level), static_cast<unsigned char>(255. - level), 20);
    }
  }
  return covered;
}
} // namespace

TEST_CASE("What hides 40 % of the object is not learnt, unless it stays", "[surface-memory]")
{
  Remembered box;
  for (int k = 0; k < 20; ++k) {
    box.learnAt(truth);
  }
  const vpImage<vpRGBa> clear = box.scene.draw(truth, box.paint);
  const vpImage<vpRGBa> covered = occluded(clear);
  for (int k = 0; k < 20; ++k) {
    box.show(covered);
    CHECK(box.correlation(truth) > 0.4); // The rest of it agrees.
    CHECK(box.correlation(truth) < 0.6);
    box.memory.learn(truth, nullptr);
  }
  box.show(clear);
  CHECK(box.correlation(truth) > 0.95);
  box.show(covered);
  for (int k = 0; k < 20; ++k) { // What stays belongs to the object after all.
    box.memory.learn(truth, nullptr);
  }
  CHECK(box.correlation(truth) > 0.97);
  box.show(clear);
  CHECK(box.correlation(truth) < 0.6);
}

TEST_CASE("A patch that contradicts the memory is forgotten after some 35 frames", "[surface-memory]")
{
  Remembered box;
  for (int k = 0; k < 20; ++k) {
    box.learnAt(truth);
  }
  box.show(occluded(box.scene.draw(truth, box.paint)));
  int frames = 0;
  while (frames < 60 && box.memory.agreement(truth).known > 0.9) {
    box.memory.learn(truth, nullptr);
    ++frames;
  }
  CHECK(frames >= 34);
  CHECK(frames <= 37);
}

TEST_CASE("The light on one side of the object may change", "[surface-memory]")
{
  const Eigen::Vector3d half(0.1, 0.07, 0.05);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double gain : {0.4, 1.2}) {
      CAPTURE(axis, gain);
      Remembered box;
      box.learnAt(truth);
      box.paint.object = [&](const Eigen::Vector3d &oX) -> Color {
        const bool isOnSide = std::fabs(oX[axis]) > half[axis] - 1e-3;
        return (isOnSide ? gain : 1.) * patches(oX);
      };
      box.show(box.scene.draw(truth, box.paint));
      CHECK(box.correlation(truth) > 0.97);
      CHECK(std::fabs(box.correlation(halfTurn)) < 0.2);
    }
  }
}

TEST_CASE("The memory follows a slow change of the light's colour", "[surface-memory]")
{
  Remembered box;
  Remembered atFirst;
  atFirst.learnAt(truth);
  for (int k = 0; k < 50; ++k) {
    box.paint.object = [k](const Eigen::Vector3d &oX) -> Color {
      return patches(oX).cwiseProduct(Color(1., 1. - 0.015 * k, 1. - 0.015 * k));
    };
    box.learnAt(truth);
  }
  CHECK(box.correlation(truth) > 0.97);
  atFirst.show(box.scene.draw(truth, box.paint));
  CHECK(atFirst.correlation(truth) < 0.7);
}
