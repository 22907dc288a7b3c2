// SPDX-License-Identifier: GPL-2.0-or-later
#include "surfaceScenes.h"

#include <catchMain.h>
#include <countAllocations.h>

#include <limits>

namespace {
using surfaceScenes::halfTurn;
using surfaceScenes::patches;
using surfaceScenes::Remembered;
using surfaceScenes::seenFrom;
using surfaceScenes::truth;

vpImage<unsigned char> grayOf(const vpImage<vpRGBa> &I)
{
  vpImage<unsigned char> gray;
  vpImageConvert::convert(I, gray);
  return gray;
}

vpImage<vpRGBa> cropped(const vpImage<vpRGBa> &I, unsigned int columns, unsigned int rows)
{
  vpImage<vpRGBa> part(rows, columns);
  for (unsigned int i = 0; i < rows; ++i) {
    for (unsigned int j = 0; j < columns; ++j) {
      part[i][j] = I[i][j];
    }
  }
  return part;
}

void checkNothing(const vpSurfaceMemory::Agreement &agreement)
{
  CHECK(agreement.correlation == exactly(0.));
  CHECK(agreement.known == exactly(0.));
  CHECK(agreement.texture == exactly(0.));
}
} // namespace

TEST_CASE("The true pose agrees with the memory and half a turn does not", "[surface-memory]")
{
  Remembered box;
  checkNothing(box.memory.agreement(truth));
  box.learnAt(halfTurn);
  box.learnAt(truth);
  CHECK(box.memory.texture() > 0.9);
  CHECK(box.memory.texture() <= 1.);
  const vpSurfaceMemory::Agreement right = box.memory.agreement(truth);
  CHECK(right.correlation > 0.9);
  CHECK(right.correlation <= 1. + 1e-6);
  CHECK(right.known > 0.95); // Patches of which hardly a place is in view are not.
  const vpSurfaceMemory::Agreement wrong = box.memory.agreement(halfTurn);
  CHECK(std::fabs(wrong.correlation) < 0.4);
  CHECK(wrong.known > 0.95);
  // Also where it moved.
  const vpHomogeneousMatrix moved = truth * vpHomogeneousMatrix(0.01, 0.01, 0., 0.1, -0.1, 0.1);
  box.show(box.scene.draw(moved, box.paint));
  CHECK(box.correlation(moved) > 0.8);
  CHECK(box.correlation(truth) < box.correlation(moved) - 0.2);
}

TEST_CASE("Brightness and contrast of the image do not matter", "[surface-memory]")
{
  Remembered box;
  box.learnAt(truth);
  box.paint.gain = 0.6;
  vpImage<vpRGBa> I = box.scene.draw(truth, box.paint);
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    for (unsigned char *channel : {&I.bitmap[k].R, &I.bitmap[k].G, &I.bitmap[k].B}) {
      *channel = static_cast<unsigned char>(*channel + 80);
    }
  }
  box.show(I);
  CHECK(box.correlation(truth) > 0.97);
}

TEST_CASE("Sides that were never seen are not known", "[surface-memory]")
{
  Remembered box;
  box.learnAt(truth);
  const vpSurfaceMemory::Agreement half = box.memory.agreement(halfTurn);
  CHECK(half.known > 0.2); // One of three sides.
  CHECK(half.known < 0.8);
  // Half a turn about a line across that of sight: the three other sides.
  const vpHomogeneousMatrix oMc = truth.inverse();
  Eigen::Vector3d across = Eigen::Vector3d(oMc[0][3], oMc[1][3], oMc[2][3]).cross(Eigen::Vector3d::UnitX());
  across *= M_PI / across.norm();
  checkNothing(box.memory.agreement(truth * vpHomogeneousMatrix(0., 0., 0., across.x(), across.y(), across.z())));
  box.memory.reset();
  CHECK(box.memory.texture() == exactly(0.));
  checkNothing(box.memory.agreement(truth));
}

TEST_CASE("Gray images do as well, and another kind of image begins anew", "[surface-memory]")
{
  Remembered box;
  const vpImage<vpRGBa> colors = box.scene.draw(truth, box.paint);
  const vpImage<unsigned char> grays = grayOf(colors);
  box.learnAt(truth);
  box.show(grays);
  CHECK(box.memory.texture() == exactly(0.));
  checkNothing(box.memory.agreement(truth));
  box.memory.learn(truth, nullptr);
  box.show(grayOf(box.scene.draw(halfTurn, box.paint)));
  box.memory.learn(halfTurn, nullptr);
  box.show(grays);
  CHECK(box.correlation(truth) > 0.97);
  CHECK(std::fabs(box.correlation(halfTurn)) < 0.5);
  box.show(colors);
  checkNothing(box.memory.agreement(truth));
}

TEST_CASE("Images without the object do not agree", "[surface-memory]")
{
  Remembered box;
  box.learnAt(truth);
  vpHomogeneousMatrix away = truth;
  away[0][3] = 5.;
  box.show(box.scene.draw(away, box.paint));
  CHECK(std::fabs(box.correlation(truth)) < 0.4);
  box.show(vpImage<vpRGBa>(colorScenes::height, colorScenes::width, vpRGBa(90, 120, 30)));
  CHECK(std::fabs(box.correlation(truth)) < 0.05);
}

TEST_CASE("Poses with nothing in view, and places outside the image", "[surface-memory]")
{
  Remembered box;
  box.learnAt(truth);
  vpHomogeneousMatrix cMo = truth;
  cMo[2][3] = -0.5;
  checkNothing(box.memory.agreement(cMo));
  cMo = truth;
  cMo[0][3] = 5.;
  checkNothing(box.memory.agreement(cMo));
  cMo[0][3] = std::numeric_limits<double>::quiet_NaN();
  checkNothing(box.memory.agreement(cMo));
  box.memory.learn(cMo, nullptr);
  CHECK(box.correlation(truth) > 0.98);
  cMo = truth;
  cMo[2][3] = 0.02; // Around the camera.
  CHECK(std::isfinite(box.correlation(cMo)));
  cMo = truth;
  cMo[0][3] += 0.25; // Half of it in the image.
  box.show(box.scene.draw(cMo, box.paint));
  CHECK(box.correlation(cMo) > 0.75);
}

TEST_CASE("Images of odd and of tiny sizes", "[surface-memory]")
{
  Remembered box;
  box.learnAt(truth);
  const vpImage<vpRGBa> I = box.scene.draw(truth, box.paint);
  box.show(cropped(I, colorScenes::width - 1, colorScenes::height - 1));
  CHECK(box.correlation(truth) > 0.98);
  for (const unsigned int size : {1U, 2U, 3U}) {
    box.show(cropped(I, size, size));
    CHECK(box.memory.agreement(truth).known == exactly(0.));
    box.memory.learn(truth, nullptr);
  }
  box.show(I);
  CHECK(box.correlation(truth) > 0.98);
}

TEST_CASE("Without places nothing is remembered", "[surface-memory]")
{
  Remembered box;
  box.memory.setSamples({});
  box.learnAt(truth);
  CHECK(box.memory.texture() == exactly(0.));
  checkNothing(box.memory.agreement(truth));
}

TEST_CASE("What the object hides itself is not learnt", "[surface-memory]")
{
  const auto model = std::make_shared<const vpTrackedModel>(modelShapes::build(modelShapes::lPolygons(0.2, 0.08)));
  colorScenes::Scene scene(*model);
  colorScenes::Paint paint;
  paint.object = patches;
  // One arm is behind the other.
  const vpHomogeneousMatrix cMo = seenFrom({1., -1., 0.05}, model->centre());
  const vpImage<vpRGBa> I = scene.draw(cMo, paint);
  vpRenderedView depth;
  vpCpuRenderer(model).render(cMo, colorScenes::makeCamera(), colorScenes::width, colorScenes::height,
                              vpRenderOptions(), depth);
  vpFrameSource source;
  const auto knownAfter = [&](const vpRenderedView *view) {
    vpSurfaceMemory memory;
    memory.setSamples(vpSampleSurface(*model, 500));
    memory.setFrame(source.frame(I, colorScenes::makeCamera(), nullptr));
    memory.learn(cMo, view);
    return memory.agreement(cMo).known;
  };
  CHECK(knownAfter(nullptr) > 0.95);
  CHECK(knownAfter(&depth) < 0.9);
  CHECK(knownAfter(&depth) > 0.4);
}

TEST_CASE("A second frame of the same size allocates nothing", "[surface-memory]")
{
  Remembered box;
  box.learnAt(truth);
  const vpImage<vpRGBa> I = box.scene.draw(halfTurn, box.paint);
  const vpCueFrame frame = box.source.frame(I, colorScenes::makeCamera(), nullptr);
  const std::size_t before = countAllocations::allocations;
  box.memory.setFrame(frame);
  const double correlation = box.memory.agreement(halfTurn).correlation;
  box.memory.learn(halfTurn, nullptr);
  CHECK(countAllocations::allocations == before);
  CHECK(std::isfinite(correlation));
}

TEST_CASE("The memory goes back to what it knew before", "[surface-memory]")
{
  Remembered box;
  box.learnAt(truth);
  const vpSurfaceMemory::Reference before = box.memory.reference();
  const double correlation = box.correlation(truth);
  const vpImage<vpRGBa> I = box.scene.draw(truth, box.paint);
  box.memory.reset();
  box.paint.object = [](const Eigen::Vector3d &oX) { return patches(oX + Eigen::Vector3d::Constant(0.5)); };
  box.learnAt(truth);
  box.show(I);
  REQUIRE(box.correlation(truth) < correlation - 0.2);
  const double now = box.correlation(truth);
  CHECK(box.memory.agreement(truth, before).correlation == exactly(correlation));
  CHECK(box.correlation(truth) == exactly(now)); // Asking changes nothing.
  box.memory.setReference(before);
  CHECK(box.correlation(truth) == exactly(correlation));

  // Not to what gray images told, nor to other places.
  Remembered gray;
  gray.show(grayOf(box.scene.draw(truth, box.paint)));
  gray.memory.learn(truth, nullptr);
  const double texture = gray.memory.texture();
  CHECK(texture > 0.);
  CHECK(gray.memory.agreement(truth, before).known == exactly(0.));
  gray.memory.setReference(before);
  CHECK(gray.memory.texture() == exactly(texture));
  CHECK(gray.memory.reference().channels == 1);
  gray.memory.setSamples(vpSampleSurface(colorScenes::makeBox(), 20));
  CHECK(gray.memory.agreement(truth, before).known == exactly(0.));
  gray.memory.setReference(before);
  CHECK(gray.memory.reference().weights.size() != before.weights.size());
}
