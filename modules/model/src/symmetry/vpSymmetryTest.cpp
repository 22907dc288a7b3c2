// SPDX-License-Identifier: GPL-2.0-or-later
#include "symmetry/vpSymmetryTest.h"

#include <visp3/model/vpSurfaceSamples.h>

#include <algorithm>
#include <cmath>
#include <numeric>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t surfacePlaces = 800;
const std::size_t mostVertices = 2000;
const std::size_t mostEdgePlaces = 1500;
// Edges are looked at in steps of this many tolerances.
const double edgeStep = 1.;
// Directions of the same edge differ by less: a circle may be made of few straight bits.
const double sameDirection = 0.96;
const int circleSegments = 72;
// Of the places with colours; those at the seams of a texture are wrong about theirs.
const double wrongColors = 0.03;

// Spread over a list, so that what does not fit is met early.
template <typename Value> void shuffle(std::vector<Value> &values)
{
  const std::size_t count = values.size();
  std::size_t step = static_cast<std::size_t>(0.618 * static_cast<double>(count)) | 1U;
  while (std::gcd(step, count) != 1) {
    step += 2;
  }
  std::vector<Value> spread;
  spread.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    spread.push_back(values[i * step % count]);
  }
  values = std::move(spread);
}

std::vector<vpSegment> segmentsOf(const vpTrackedModel &model)
{
  std::vector<vpSegment> segments;
  const auto add = [&segments](const Eigen::Vector3d &start, const Eigen::Vector3d &end) {
    segments.push_back({start, end, (end - start).normalized()});
  };
  for (const vpModelEdge &edge : model.edges()) {
    add(model.vertices()[static_cast<std::size_t>(edge.vertex[0])],
        model.vertices()[static_cast<std::size_t>(edge.vertex[1])]);
  }
  for (const vpModelCircle &circle : model.circles()) {
    const Eigen::Vector3d u = circle.radius * circle.normal.unitOrthogonal();
    const Eigen::Vector3d v = circle.normal.cross(u);
    const auto at = [&](int i) {
      const double angle = 2. * M_PI * i / circleSegments;
      return Eigen::Vector3d(circle.centre + std::cos(angle) * u + std::sin(angle) * v);
    };
    for (int i = 0; i < circleSegments; ++i) {
      add(at(i), at(i + 1));
    }
  }
  return segments;
}
} // namespace

vpSymmetryTest::vpSymmetryTest(const vpTrackedModel &model, const vpSymmetryOptions &options)
    : m_model(model), m_options(options), m_reach(options.tolerance * model.diameter()), m_grid(model, m_reach),
      m_shader(model)
{
  addSurface();
  addVertices();
  shuffle(m_places);
  const std::vector<vpSegment> segments = segmentsOf(model);
  m_edges = vpSegmentTree(segments, m_reach);
  addEdgePlaces(segments);
  shuffle(m_edgePlaces);
}

Eigen::Vector3d vpSymmetryTest::colorAt(const vpSurfacePlace &place) const
{
  const vpRGBa color = m_shader.color(place.triangle, place.weights);
  return Eigen::Vector3d(color.R, color.G, color.B) / 255.;
}

void vpSymmetryTest::addSurface()
{
  const vpModelAppearance &look = m_model.appearance();
  const bool hasColors = !look.color.empty() || !look.image.empty();
  for (const vpSurfaceSample &sample : vpSampleSurface(m_model, surfacePlaces)) {
    Place place;
    place.position = sample.position.cast<double>();
    place.normal = sample.normal.cast<double>();
    const vpSurfacePlace own = m_grid.nearest(place.position, place.normal);
    place.hasColor = hasColors && own.triangle >= 0;
    place.color = place.hasColor ? colorAt(own) : Eigen::Vector3d::Zero();
    m_places.push_back(place);
  }
}

void vpSymmetryTest::addVertices()
{
  std::vector<int> used;
  for (const vpModelTriangle &triangle : m_model.triangles()) {
    used.insert(used.end(), triangle.vertex.begin(), triangle.vertex.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const std::size_t step = used.size() / mostVertices + 1;
  for (std::size_t i = 0; i < used.size(); i += step) {
    Place place;
    place.position = m_model.vertices()[static_cast<std::size_t>(used[i])];
    place.normal.setZero();
    place.color.setZero();
    m_places.push_back(place);
  }
}

void vpSymmetryTest::addEdgePlaces(const std::vector<vpSegment> &segments)
{
  double length = 0.;
  for (const vpSegment &segment : segments) {
    length += (segment.end - segment.start).norm();
  }
  const double step = std::max(edgeStep * m_reach, length / static_cast<double>(mostEdgePlaces));
  for (const vpSegment &segment : segments) {
    const double own = (segment.end - segment.start).norm();
    const int count = 1 + static_cast<int>(own / step);
    for (int i = 0; i < count; ++i) {
      m_edgePlaces.push_back({segment.start + (i + 0.5) * own / count * segment.direction, segment.direction});
    }
  }
}

bool vpSymmetryTest::surfaceFits(const Eigen::Isometry3d &turn) const
{
  std::size_t colored = 0;
  std::size_t wrong = 0;
  for (const Place &place : m_places) {
    const vpSurfacePlace found = m_grid.nearest(turn * place.position, turn.linear() * place.normal);
    if (found.triangle < 0) {
      return false;
    }
    if (place.hasColor) {
      ++colored;
      wrong += (colorAt(found) - place.color).cwiseAbs().maxCoeff() > m_options.colorTolerance ? 1U : 0U;
    }
  }
  return static_cast<double>(wrong) <= wrongColors * static_cast<double>(colored);
}

bool vpSymmetryTest::edgesFit(const Eigen::Isometry3d &turn) const
{
  return std::all_of(m_edgePlaces.begin(), m_edgePlaces.end(), [&](const EdgePlace &place) {
    return m_edges.hasNear(turn * place.position, turn.linear() * place.direction, sameDirection);
  });
}

bool vpSymmetryTest::operator()(const Eigen::Isometry3d &turn) const
{
  return surfaceFits(turn) && edgesFit(turn);
}

END_VISP_NAMESPACE
