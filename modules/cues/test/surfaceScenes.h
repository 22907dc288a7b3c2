// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef surfaceScenes_h
#define surfaceScenes_h

#include "colorScenes.h"

#include <visp3/cues/vpSurfaceMemory.h>
#include <visp3/se3/vpPoseExponential.h>

/*! \file surfaceScenes.h A box with patches of all colours, and a memory of its surface. */

BEGIN_VISP_NAMESPACE
namespace surfaceScenes {
using colorScenes::Color;

//! Patches of all colours; no border between them lies on a side of the box.
inline Color patches(const Eigen::Vector3d &oX)
{
  const auto part = [&oX](int axis) { return colorScenes::cell(oX[axis], 0.022); };
  const auto level = [&](int channel) {
    return 40. + 170. * colorScenes::hashed(part(0) + 100 * channel, part(1), part(2));
  };
  return {level(0), level(1), level(2)};
}

//! An object's middle half a metre before the camera, seen from a direction of its own frame.
inline vpHomogeneousMatrix seenFrom(const Eigen::Vector3d &direction, const Eigen::Vector3d &middle)
{
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(direction, -Eigen::Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = Eigen::Vector3d(0.01, -0.01, 0.5) - pose.linear() * middle;
  return vpPoseExponential::fromEigen(pose);
}

//! Three sides of the box are well in view.
inline const vpHomogeneousMatrix truth = seenFrom({0.6, 0.5, 0.6}, Eigen::Vector3d::Zero());
//! The same outline.
inline const vpHomogeneousMatrix halfTurn = truth * vpHomogeneousMatrix(0., 0., 0., 0., 0., M_PI);

//! A memory of a box, and images to show to it.
struct Remembered
{
  Remembered()
  {
    paint.object = patches;
    memory.setSamples(vpSampleSurface(colorScenes::makeBox(), 500));
  }

  template <typename Pixel> void show(const vpImage<Pixel> &I)
  {
    memory.setFrame(source.frame(I, colorScenes::makeCamera(), nullptr));
  }
  void learnAt(const vpHomogeneousMatrix &cMo)
  {
    show(scene.draw(cMo, paint));
    memory.learn(cMo, nullptr);
  }
  double correlation(const vpHomogeneousMatrix &cMo) const { return memory.agreement(cMo).correlation; }

  colorScenes::Scene scene{colorScenes::makeBox()};
  colorScenes::Paint paint;
  vpFrameSource source;
  vpSurfaceMemory memory;
};

} // namespace surfaceScenes
END_VISP_NAMESPACE
#endif
