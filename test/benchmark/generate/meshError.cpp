// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/meshError.h"

#include "generate/motion.h"

#include <visp3/se3/vpPoseRandom.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

namespace bench {
namespace {
// All lengths are shares of the diameter. Assumed for a scan with a cheap depth camera: of an object of 20 cm, edges of
// 5 mm, 2 mm too large, 1 mm uneven.
const double edgeLength = 0.025;
const double sizeError = 0.01;
const double unevenness = 0.005; // Root mean square.
const double shortestWave = 0.08;
const double longestWave = 0.4;
const int waves = 24;

// Sharp edges lose half a percent of the diameter: silhouettes shrink by as much as the size is wrong.
const int smoothings = 1;

ColoredTriangle withCorners(const ColoredTriangle &like, const ColoredTriangle &a, std::size_t i,
                            const ColoredTriangle &b, std::size_t j, const ColoredTriangle &c, std::size_t k)
{
  ColoredTriangle result = like;
  result.position = {{a.position[i], b.position[j], c.position[k]}};
  result.color = {{a.color[i], b.color[j], c.color[k]}};
  result.texture = {{a.texture[i], b.texture[j], c.texture[k]}};
  return result;
}

//! Corner i of the result is the middle of edge i, from corner i to the next.
ColoredTriangle middles(const ColoredTriangle &t)
{
  ColoredTriangle result = t;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    result.position[i] = 0.5 * (t.position[i] + t.position[j]);
    result.color[i] = 0.5F * (t.color[i] + t.color[j]);
    result.texture[i] = 0.5F * (t.texture[i] + t.texture[j]);
  }
  return result;
}

//! Whether an edge is halved depends on its ends alone: its two triangles agree.
void split(const ColoredTriangle &t, double length, std::vector<ColoredTriangle> &parts)
{
  std::array<bool, 3> isLong{};
  for (std::size_t i = 0; i < 3; ++i) {
    isLong[i] = (t.position[i] - t.position[(i + 1) % 3]).norm() > length;
  }
  const auto count = std::count(isLong.begin(), isLong.end(), true);
  // Turned so that a single long edge, or the two others' common corner, comes first.
  const std::size_t i = static_cast<std::size_t>(std::find(isLong.begin(), isLong.end(), count == 1) -
                                                 isLong.begin()); // 3 where all are equal.
  const std::size_t a = i % 3;
  const std::size_t b = (i + 1) % 3;
  const std::size_t c = (i + 2) % 3;
  const ColoredTriangle m = middles(t);
  if (count == 0) {
    parts.push_back(t);
  } else if (count == 1) {
    parts.push_back(withCorners(t, t, a, m, a, t, c));
    parts.push_back(withCorners(t, m, a, t, b, t, c));
  } else if (count == 2) {
    parts.push_back(withCorners(t, m, b, t, c, m, c));
    parts.push_back(withCorners(t, t, a, t, b, m, b));
    parts.push_back(withCorners(t, t, a, m, b, m, c));
  } else {
    parts.push_back(m);
    parts.push_back(withCorners(t, t, a, m, a, m, c));
    parts.push_back(withCorners(t, m, a, t, b, m, b));
    parts.push_back(withCorners(t, m, c, m, b, t, c));
  }
}

//! Vertices at equal places are one.
struct WeldedVertices
{
  explicit WeldedVertices(const std::vector<ColoredTriangle> &triangles)
  {
    std::map<std::array<double, 3>, std::size_t> known;
    for (const ColoredTriangle &triangle : triangles) {
      for (const Eigen::Vector3d &p : triangle.position) {
        const auto place = known.emplace(std::array<double, 3>{{p.x(), p.y(), p.z()}}, points.size());
        if (place.second) {
          points.push_back(p);
        }
        corner.push_back(place.first->second);
      }
    }
  }

  std::vector<Eigen::Vector3d> points;
  std::vector<std::size_t> corner; //!< Index into points of each triangle's corners, three to a triangle.
};

//! Each vertex goes half way to the mean of its neighbours.
void smooth(WeldedVertices &vertices)
{
  std::vector<Eigen::Vector3d> sum(vertices.points.size(), Eigen::Vector3d::Zero());
  std::vector<double> count(vertices.points.size(), 0.);
  for (std::size_t i = 0; i < vertices.corner.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const std::size_t from = vertices.corner[i];
    const std::size_t to = vertices.corner[next];
    sum[from] += vertices.points[to];
    sum[to] += vertices.points[from];
    ++count[from];
    ++count[to];
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    vertices.points[i] = 0.5 * (vertices.points[i] + sum[i] / count[i]);
  }
}

//! Displacements that change smoothly from place to place, as errors of depth do.
class Unevenness
{
public:
  Unevenness(double diameter, vpPoseRandom &random)
  {
    for (int i = 0; i < waves; ++i) {
      const double length = diameter * (shortestWave + (longestWave - shortestWave) * random.uniform());
      m_waves.push_back({2. * M_PI / length * direction(random), direction(random), 2. * M_PI * random.uniform()});
    }
    m_amplitude = unevenness * diameter * std::sqrt(2. / waves);
  }

  Eigen::Vector3d at(const Eigen::Vector3d &p) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Wave &wave : m_waves) {
      sum += m_amplitude * std::sin(wave.number.dot(p) + wave.phase) * wave.direction;
    }
    return sum;
  }

private:
  struct Wave
  {
    Eigen::Vector3d number; //!< Radians per metre.
    Eigen::Vector3d direction;
    double phase;
  };

  static Eigen::Vector3d direction(vpPoseRandom &random)
  {
    Eigen::Vector3d v;
    v << random.normal(), random.normal(), random.normal();
    return v.normalized();
  }

  std::vector<Wave> m_waves;
  double m_amplitude = 0.;
};
} // namespace

std::vector<ColoredTriangle> subdivide(std::vector<ColoredTriangle> triangles, double length)
{
  for (std::size_t before = 0; before != triangles.size();) {
    before = triangles.size();
    std::vector<ColoredTriangle> parts;
    for (const ColoredTriangle &triangle : triangles) {
      split(triangle, length, parts);
    }
    triangles.swap(parts);
  }
  return triangles;
}

std::vector<ColoredTriangle> reconstructed(const std::vector<ColoredTriangle> &triangles, double strength,
                                           std::uint64_t seed)
{
  std::vector<Eigen::Vector3d> points;
  for (const ColoredTriangle &triangle : triangles) {
    points.insert(points.end(), triangle.position.begin(), triangle.position.end());
  }
  const MotionExtent extent(points);
  std::vector<ColoredTriangle> result = subdivide(triangles, edgeLength * extent.diameter);
  WeldedVertices vertices(result);
  for (int i = 0; i < std::lround(smoothings * strength); ++i) {
    smooth(vertices);
  }
  vpPoseRandom random(seed, {0x6d657368});
  const double size = 1. + strength * (random.uniform() < 0.5 ? -sizeError : sizeError);
  const Unevenness uneven(extent.diameter, random);
  for (Eigen::Vector3d &p : vertices.points) {
    p = extent.centre + size * (p - extent.centre) + strength * uneven.at(p);
  }
  for (std::size_t i = 0; i < vertices.corner.size(); ++i) {
    result[i / 3].position[i % 3] = vertices.points[vertices.corner[i]];
  }
  return result;
}

} // namespace bench
