// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/startPoses.h"

#include <visp3/se3/vpPoseExponential.h>

namespace bench {

namespace {
const unsigned int bisections = 40;
// Longest motion that is tried for an offset: in diameters, and radians.
const double longest = 1.;

// The same number for the same name in every run.
std::uint64_t numberOf(const std::string &name)
{
  std::uint64_t number = 0;
  for (const char c : name) {
    number = 31 * number + static_cast<unsigned char>(c);
  }
  return number;
}
} // namespace

vpHomogeneousMatrix offBy(double pixels, const vpHomogeneousMatrix &cMo, const vpTrackedModel &model,
                          const PoseErrorMeasure &measure, const vpCameraParameters &cam, vpPoseRandom &random)
{
  vpPoseTangent direction = random.normalTangent();
  direction.head<3>() *= model.diameter();
  Eigen::Isometry3d toCentre = Eigen::Isometry3d::Identity();
  toCentre.translation() = model.centre();
  const Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo) * toCentre;
  const auto moved = [&](double length) {
    const vpHomogeneousMatrix motion = vpPoseExponential::exp(length * direction);
    return vpPoseExponential::fromEigen(pose * vpPoseExponential::toEigen(motion) * toCentre.inverse());
  };
  double low = 0.;
  double high = longest;
  for (unsigned int i = 0; i < bisections; ++i) {
    const double middle = 0.5 * (low + high);
    (measure(moved(middle), cMo, cam).pixels < pixels ? low : high) = middle;
  }
  return moved(low);
}

vpHomogeneousMatrix StartPoses::at(const std::string &scene, const SequenceFrame &frame, const vpTrackedModel &model,
                                   const PoseErrorMeasure &measure) const
{
  if (!(pixels > 0.)) {
    return frame.cMo;
  }
  vpPoseRandom random(static_cast<std::uint64_t>(seed), {numberOf(scene), static_cast<std::uint64_t>(frame.id)});
  return offBy(pixels, frame.cMo, model, measure, frame.cam, random);
}

} // namespace bench
