// SPDX-License-Identifier: GPL-2.0-or-later
#include "view/vpRimTracer.h"

#include <Eigen/Geometry>

#include <algorithm>

BEGIN_VISP_NAMESPACE

vpRimTracer::vpRimTracer(vpModelView &view, const vpModelTopology &topology, const vpViewCamera &camera)
    : m_view(view), m_model(view.model()), m_topology(topology), m_camera(camera)
{
}

const vpModelTriangle &vpRimTracer::triangleAt(std::size_t index) const
{
  return m_model.triangles()[static_cast<std::size_t>(m_model.smoothTriangles()[index])];
}

void vpRimTracer::computeFacing()
{
  // A loop over plain arrays, which compilers turn into vector instructions: it visits every normal of the mesh.
  const vpModelTopology::Facings &normals = m_topology.facings();
  const Eigen::Vector3f oC = m_camera.oC.cast<float>();
  const std::size_t count = normals.offset.size();
  m_view.m_facing.resize(count);
  float *facing = m_view.m_facing.data();
  const float *x = normals.x.data();
  const float *y = normals.y.data();
  const float *z = normals.z.data();
  const float *offset = normals.offset.data();
  for (std::size_t i = 0; i < count; ++i) {
    facing[i] = offset[i] - (x[i] * oC.x() + y[i] * oC.y() + z[i] * oC.z());
  }
}

float vpRimTracer::facing(std::size_t triangle, std::size_t corner) const
{
  return m_view.m_facing[static_cast<std::size_t>(m_topology.facingCorners()[triangle][corner % 3])];
}

bool vpRimTracer::crosses(std::size_t triangle, std::size_t side) const
{
  return (facing(triangle, side) < 0.F) != (facing(triangle, side + 1) < 0.F);
}

// Of all that is done for a rim this alone looks at every triangle, or at the patches that they are in.
void vpRimTracer::markRims(std::vector<char> &visited) const
{
  const std::array<int, 3> *corners = m_topology.facingCorners().data();
  const float *facing = m_view.m_facing.data();
  for (const vpModelTopology::Patch &patch : m_topology.patches()) {
    if (patch.normals.side(m_camera.oC) != 0) {
      continue;
    }
    for (const int triangle : patch.triangles) {
      const std::array<int, 3> &corner = corners[triangle];
      const bool first = facing[corner[0]] < 0.F;
      visited[static_cast<std::size_t>(triangle)] =
          first == (facing[corner[1]] < 0.F) && first == (facing[corner[2]] < 0.F);
    }
  }
}

std::size_t vpRimTracer::otherSide(std::size_t triangle, std::size_t side) const
{
  return crosses(triangle, (side + 1) % 3) ? (side + 1) % 3 : (side + 2) % 3;
}

// entry: the side by which the next triangle is entered.
bool vpRimTracer::advance(Step &step, std::size_t &entry) const
{
  const int next = m_topology.neighbours()[step.triangle][step.side];
  if (next < 0) {
    return false;
  }
  const std::array<int, 3> &back = m_topology.neighbours()[static_cast<std::size_t>(next)];
  entry = 0;
  while (back[entry] != static_cast<int>(step.triangle) || !crosses(static_cast<std::size_t>(next), entry)) {
    if (++entry == 3) {
      return false;
    }
  }
  step.triangle = static_cast<std::size_t>(next);
  step.side = otherSide(step.triangle, entry);
  return true;
}

void vpRimTracer::trace()
{
  m_view.m_rims.clear();
  m_view.m_rimEnds.clear();
  computeFacing();
  std::vector<char> &visited = m_view.m_visited;
  visited.assign(m_model.smoothTriangles().size(), 1);
  markRims(visited);
  // In the order of the triangles, whatever patches they are in.
  for (auto i = std::find(visited.begin(), visited.end(), 0); i != visited.end(); i = std::find(i, visited.end(), 0)) {
    traceFrom(static_cast<std::size_t>(i - visited.begin()));
  }
}

void vpRimTracer::traceFrom(std::size_t triangle)
{
  // Back to where the curve begins, or once around a closed one.
  Step step{triangle, crosses(triangle, 0) ? 0U : 1U};
  std::size_t entry = 0;
  for (Step probe = step; advance(probe, entry) && probe.triangle != triangle;) {
    step = probe;
  }
  std::vector<char> &visited = m_view.m_visited;
  std::size_t from = step.side;
  step.side = otherSide(step.triangle, step.side);
  bool isAtNode = false; // The last one is where this triangle's bit begins.
  do {
    visited[step.triangle] = 1;
    const bool isConvex = isConvexRim(step.triangle);
    if (isConvex) {
      if (!isAtNode) {
        addNode(step.triangle, from, false);
      }
      addNode(step.triangle, step.side, true);
    }
    isAtNode = isConvex;
  } while (advance(step, from) && !visited[step.triangle]);
  m_view.m_rimEnds.push_back(m_view.m_rims.size());
}

void vpRimTracer::sample(vpContourSampler &sampler) const
{
  vpModelView::Piece piece;
  piece.parameter = {{0., 1.}};
  piece.slides = true;
  const vpModelView::RimNode *node = m_view.m_rims.data();
  for (const std::size_t end : m_view.m_rimEnds) {
    for (; node != m_view.m_rims.data() + end; ++node) {
      piece.position = {{piece.position[1], node->position}};
      piece.direction = {{piece.direction[1], node->direction}};
      piece.outward = {{piece.outward[1], node->outward}};
      if (node->joined) {
        sampler.add(piece);
      } else {
        sampler.interrupt();
      }
    }
    sampler.sample(false);
  }
}

bool vpRimTracer::isConvexRim(std::size_t triangle) const
{
  const vpModelTopology::Slope &slope = m_topology.slopes()[triangle];
  if (!slope.oriented) {
    return true;
  }
  // Along the line of sight a rim that can be seen turns from facing the camera to facing away; in a hollow it is the
  // other way round, and the surface hides it.
  const double d1 = facing(triangle, 1) - facing(triangle, 0);
  const double d2 = facing(triangle, 2) - facing(triangle, 0);
  const Eigen::Vector3d gradient = d1 * slope.gradients[0] + d2 * slope.gradients[1];
  return gradient.dot(slope.corner - m_camera.oC) > 0.;
}

void vpRimTracer::addNode(std::size_t triangle, std::size_t side, bool joined)
{
  const vpModelTriangle &t = triangleAt(triangle);
  const std::size_t next = (side + 1) % 3;
  const double g0 = facing(triangle, side);
  const double g1 = facing(triangle, next);
  const double s = g0 / (g0 - g1);
  const Eigen::Vector3d position = (1. - s) * m_model.vertices()[static_cast<std::size_t>(t.vertex[side])] +
                                   s * m_model.vertices()[static_cast<std::size_t>(t.vertex[next])];
  const Eigen::Vector3d normal = (1. - s) * m_model.normals()[static_cast<std::size_t>(t.normal[side])] +
                                 s * m_model.normals()[static_cast<std::size_t>(t.normal[next])];
  // In the image a rim runs perpendicular to the surface's normal, which is smoother than the triangles' bits of curve.
  const Eigen::Vector3d direction = normal.cross(position - m_camera.oC);
  const bool oriented = m_topology.slopes()[triangle].oriented;
  m_view.m_rims.push_back({position, direction, oriented ? normal : Eigen::Vector3d::Zero(), joined});
}

END_VISP_NAMESPACE
