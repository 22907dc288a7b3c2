// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/surfaceNet.h"

#include <visp3/se3/vpPoseRandom.h>

#include <algorithm>
#include <cmath>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
using Point = Eigen::Vector3d;

//! A limb between two points that gets thinner or thicker, or a ball where both are the same; metres.
struct Limb
{
  Point start;
  Point end;
  double startRadius;
  double endRadius;
  Eigen::Vector3f color;

  double distance(const Point &p) const
  {
    const Point axis = end - start;
    const double length = axis.squaredNorm();
    const double share = length > 0. ? std::clamp((p - start).dot(axis) / length, 0., 1.) : 0.;
    return (p - start - share * axis).norm() - (startRadius + share * (endRadius - startRadius));
  }
};

//! y is up, z to the front; about 0.15 m tall. One arm is raised and the hat sits askew, so that no symmetry is left.
std::vector<Limb> makeLimbs(std::uint64_t seed)
{
  vpPoseRandom random(seed, {0x666967757265});
  const auto tone = [&](float r, float g, float b) {
    const auto vary = [&](float c) { return c * static_cast<float>(0.9 + 0.2 * random.uniform()); };
    return Eigen::Vector3f(vary(r), vary(g), vary(b)).cwiseMin(1.F).eval();
  };
  const Eigen::Vector3f skin = tone(0.88F, 0.66F, 0.50F);
  const Eigen::Vector3f coat = tone(0.75F, 0.16F, 0.14F);
  const Eigen::Vector3f trousers = tone(0.14F, 0.22F, 0.50F);
  const Eigen::Vector3f shoes = tone(0.22F, 0.15F, 0.10F);
  const Eigen::Vector3f hat = tone(0.14F, 0.46F, 0.24F);
  const Eigen::Vector3f bag = tone(0.90F, 0.72F, 0.15F);
  return {{{0.000, -0.012, 0.000}, {0.000, 0.018, 0.000}, 0.027, 0.021, coat},
          {{0.000, 0.044, 0.003}, {0.000, 0.047, 0.003}, 0.0205, 0.0205, skin},
          {{0.000, 0.043, 0.022}, {0.001, 0.042, 0.028}, 0.0045, 0.0035, skin},
          {{-0.003, 0.058, 0.000}, {-0.010, 0.086, -0.006}, 0.0185, 0.0045, hat},
          {{-0.022, 0.018, 0.000}, {-0.044, 0.040, 0.010}, 0.0085, 0.0070, coat},
          {{-0.047, 0.045, 0.013}, {-0.049, 0.049, 0.014}, 0.0080, 0.0070, skin},
          {{0.022, 0.017, 0.000}, {0.036, -0.012, 0.012}, 0.0085, 0.0070, coat},
          {{0.037, -0.017, 0.015}, {0.037, -0.020, 0.017}, 0.0080, 0.0075, skin},
          {{-0.012, -0.028, 0.000}, {-0.014, -0.058, 0.002}, 0.0125, 0.0095, trousers},
          {{0.012, -0.028, 0.000}, {0.015, -0.058, -0.004}, 0.0125, 0.0095, trousers},
          {{-0.014, -0.063, 0.002}, {-0.016, -0.063, 0.014}, 0.0095, 0.0085, shoes},
          {{0.015, -0.063, -0.004}, {0.019, -0.063, 0.007}, 0.0095, 0.0085, shoes},
          {{0.008, -0.002, -0.026}, {-0.006, 0.010, -0.026}, 0.0150, 0.0130, bag}};
}

//! Distance from the union of all limbs with rounded joints (a smooth minimum of exponential kind).
double smoothDistance(const std::vector<Limb> &limbs, const Point &p)
{
  const double softness = 0.0022;
  double sum = 0.;
  for (const Limb &limb : limbs) {
    sum += std::exp(-limb.distance(p) / softness);
  }
  return -softness * std::log(std::max(sum, 1e-300));
}

Eigen::Vector3f colorAt(const std::vector<Limb> &limbs, const Point &p)
{
  const Limb *nearest = &limbs.front();
  for (const Limb &limb : limbs) {
    if (limb.distance(p) < nearest->distance(p)) {
      nearest = &limb;
    }
  }
  return nearest->color;
}
} // namespace

SyntheticObject makeFigurine(std::uint64_t seed)
{
  SyntheticObject object;
  object.name = "figurine";
  object.id = 5;
  object.pixelDiameter = 250.;
  object.materials = {SurfaceMaterial{0.22F, 25.F, 0.F, 0.F}};
  const std::vector<Limb> limbs = makeLimbs(seed);
  const auto distance = [&limbs](const Point &p) { return smoothDistance(limbs, p); };
  const SurfaceNet net = makeSurfaceNet(distance, Point(-0.064, -0.080, -0.050), Point(0.054, 0.100, 0.040), 0.00164);
  for (const std::array<int, 3> &corners : net.triangles) {
    ColoredTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.position[i] = net.vertices[static_cast<std::size_t>(corners[i])];
      triangle.color[i] = colorAt(limbs, triangle.position[i]);
      triangle.texture[i] = Eigen::Vector2f::Zero();
    }
    object.triangles.push_back(triangle);
  }
  return object;
}

} // namespace bench
