// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/light.h"

#include <visp3/se3/vpPoseRandom.h>

#include <Eigen/Geometry>

#include <cmath>

namespace bench {
namespace {
// Of a lamp of 30 cm that is 1.5 m away, over its distance.
const double lampRadius = 0.1;

//! A number in [-1, 1] that belongs to a grid cell.
float cellNumber(int x, int y, int z, unsigned int which)
{
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x9E3779B1U ^ static_cast<std::uint32_t>(y) * 0x85EBCA77U ^
                    static_cast<std::uint32_t>(z) * 0xC2B2AE3DU ^ which * 0x27D4EB2FU;
  h = (h ^ (h >> 15U)) * 0x2C1B3C6DU;
  h = (h ^ (h >> 12U)) * 0x297A2D39U;
  h ^= h >> 15U;
  return static_cast<float>(h) * (2.F / 4294967296.F) - 1.F;
}

//! Smooth noise: the numbers of the eight cells around, blended.
float smoothNoise(const Eigen::Vector3f &p, unsigned int which)
{
  const Eigen::Vector3f corner = p.array().floor();
  const Eigen::Vector3f in = p - corner;
  const Eigen::Vector3f blend = in.array() * in.array() * (3.F - 2.F * in.array());
  const int x = static_cast<int>(corner.x());
  const int y = static_cast<int>(corner.y());
  const int z = static_cast<int>(corner.z());
  float sum = 0.F;
  for (int i = 0; i < 8; ++i) {
    const int dx = i & 1;
    const int dy = (i >> 1) & 1;
    const int dz = i >> 2;
    const float weight =
        (dx ? blend.x() : 1.F - blend.x()) * (dy ? blend.y() : 1.F - blend.y()) * (dz ? blend.z() : 1.F - blend.z());
    sum += weight * cellNumber(x + dx, y + dy, z + dz, which);
  }
  return sum;
}

//! Slope of foil: flat facets with crooked borders.
Eigen::Vector3f crinkles(const Eigen::Vector3f &place, const SurfaceMaterial &material)
{
  const Eigen::Vector3f p = place / material.crinkleSize;
  const Eigen::Vector3f bent =
      p + 0.9F * Eigen::Vector3f(smoothNoise(0.8F * p, 1), smoothNoise(0.8F * p, 2), smoothNoise(0.8F * p, 3));
  const int x = static_cast<int>(std::floor(bent.x()));
  const int y = static_cast<int>(std::floor(bent.y()));
  const int z = static_cast<int>(std::floor(bent.z()));
  const Eigen::Vector3f facet(cellNumber(x, y, z, 4), cellNumber(x, y, z, 5), cellNumber(x, y, z, 6));
  const Eigen::Vector3f soft(smoothNoise(2.F * bent, 7), smoothNoise(2.F * bent, 8), smoothNoise(2.F * bent, 9));
  return material.crinkle * (facet + 0.8F * soft);
}
} // namespace

Light lightAt(const SyntheticObject &object, bool moves, double time, std::uint64_t seed)
{
  Light light;
  if (object.inSpace) {
    light.toLight = Eigen::Vector3d(-0.75, -0.45, -0.6).normalized();
    light.diffuse = 1.1F;
    light.ambient = 0.05F;
  }
  if (!moves) {
    return light;
  }
  vpPoseRandom random(seed, {0x6c69676874});
  const auto wave = [&](double period) { return std::sin(2. * M_PI * (time / period + random.uniform())); };
  light.toLight = Eigen::Vector3d(0.9 * wave(71.), -0.2 + 0.7 * wave(53.), -0.7).normalized();
  light.gain = static_cast<float>(0.92 + 0.33 * wave(43.));
  light.contrast = static_cast<float>(0.9 + 0.2 * wave(61.));
  return light;
}

Light lampPoint(const Light &light, int instant)
{
  // A disc filled in a spiral with the golden angle.
  const double radius = lampRadius * std::sqrt(std::fmod(0.5 + 0.618034 * instant, 1.));
  const double angle = 2.399963 * instant;
  const Eigen::Vector3d across = light.toLight.unitOrthogonal();
  const Eigen::Vector3d along = light.toLight.cross(across);
  Light moved = light;
  moved.toLight += radius * (std::cos(angle) * across + std::sin(angle) * along);
  moved.toLight.normalize();
  return moved;
}

Eigen::Vector3f shade(const SurfacePoint &point, const SurfaceMaterial &material, const Light &light,
                      const ShadowMap &shadow, const Eigen::Matrix3f &oRc)
{
  Eigen::Vector3f normal = point.normal;
  if (material.crinkle > 0.F) {
    normal = (normal + oRc.transpose() * crinkles(point.object, material)).normalized();
  }
  const Eigen::Vector3f toLight = light.toLight.cast<float>();
  const float facing = normal.dot(toLight);
  const float lit = facing > 0.F ? shadow.lit(point.camera, point.normal) : 0.F;
  const float towards = facing * lit;
  float highlight = 0.F;
  if (lit > 0.F) {
    const Eigen::Vector3f toCamera = -point.camera.normalized();
    const float along = std::max(0.F, normal.dot((toLight + toCamera).normalized()));
    // Farther away it is less than a tenth of a gray level, and a power takes time.
    if (along * material.shininess > material.shininess - 8.F) {
      highlight = 255.F * material.specular * std::pow(along, material.shininess) * lit;
    }
  }
  Eigen::Vector3f seen = point.color * (light.ambient + light.diffuse * towards);
  seen.array() += highlight;
  seen = light.gain * (128.F + light.contrast * (seen.array() - 128.F)).matrix();
  return seen.cwiseMax(0.F).cwiseMin(255.F);
}

} // namespace bench
