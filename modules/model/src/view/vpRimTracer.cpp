// SPDX-License-Identifier: GPL-2.0-or-later
#include "view/vpRimTracer.h"

#include <Eigen/Geometry>

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
  m_view.m_facing.resize(m_model.normals().size());
  for (std::size_t i = 0; i < m_model.normals().size(); ++i) {
    const int vertex = m_topology.normalVertex()[i];
    if (vertex >= 0) {
      const Eigen::Vector3d sight = m_model.vertices()[static_cast<std::size_t>(vertex)] - m_camera.oC;
      m_view.m_facing[i] = static_cast<float>(m_model.normals()[i].dot(sight));
    }
  }
}

float vpRimTracer::facing(std::size_t triangle, std::size_t corner) const
{
  return m_view.m_facing[static_cast<std::size_t>(triangleAt(triangle).normal[corner % 3])];
}

bool vpRimTracer::crosses(std::size_t triangle, std::size_t side) const
{
  return (facing(triangle, side) < 0.F) != (facing(triangle, side + 1) < 0.F);
}

bool vpRimTracer::hasRim(std::size_t triangle) const
{
  return crosses(triangle, 0) || crosses(triangle, 1);
}

std::size_t vpRimTracer::otherSide(std::size_t triangle, std::size_t side) const
{
  return crosses(triangle, (side + 1) % 3) ? (side + 1) % 3 : (side + 2) % 3;
}

bool vpRimTracer::advance(Step &step) const
{
  const int next = m_topology.neighbours()[step.triangle][step.side];
  if (next < 0) {
    return false;
  }
  const std::array<int, 3> &back = m_topology.neighbours()[static_cast<std::size_t>(next)];
  std::size_t entry = 0;
  while (back[entry] != static_cast<int>(step.triangle) || !crosses(static_cast<std::size_t>(next), entry)) {
    if (++entry == 3) {
      return false;
    }
  }
  step.triangle = static_cast<std::size_t>(next);
  step.side = otherSide(step.triangle, entry);
  return true;
}

void vpRimTracer::trace(vpContourSampler &sampler)
{
  computeFacing();
  std::vector<char> &visited = m_view.m_visited;
  visited.assign(m_model.smoothTriangles().size(), 0);
  for (std::size_t i = 0; i < visited.size(); ++i) {
    if (visited[i] || !hasRim(i)) {
      continue;
    }
    // Back to where the curve begins, or once around a closed one.
    const std::size_t side = crosses(i, 0) ? 0 : 1;
    Step step{i, side};
    for (Step probe = step; advance(probe) && probe.triangle != i;) {
      step = probe;
    }
    step.side = otherSide(step.triangle, step.side);
    do {
      visited[step.triangle] = 1;
      if (isConvexRim(step.triangle)) {
        addPiece(sampler, step.triangle, otherSide(step.triangle, step.side), step.side);
      } else {
        sampler.interrupt();
      }
    } while (advance(step) && !visited[step.triangle]);
    sampler.sample(false);
  }
}

bool vpRimTracer::isConvexRim(std::size_t triangle) const
{
  const vpModelTriangle &t = triangleAt(triangle);
  if (!m_model.faces()[static_cast<std::size_t>(t.face)].oriented) {
    return true;
  }
  // Along the line of sight a rim that can be seen turns from facing the camera to facing away; in a hollow it is the
  // other way round, and the surface hides it.
  const Eigen::Vector3d &a = m_model.vertices()[static_cast<std::size_t>(t.vertex[0])];
  const Eigen::Vector3d e1 = m_model.vertices()[static_cast<std::size_t>(t.vertex[1])] - a;
  const Eigen::Vector3d e2 = m_model.vertices()[static_cast<std::size_t>(t.vertex[2])] - a;
  const Eigen::Vector3d normal = e1.cross(e2);
  const double d1 = facing(triangle, 1) - facing(triangle, 0);
  const double d2 = facing(triangle, 2) - facing(triangle, 0);
  const Eigen::Vector3d gradient = d1 * e2.cross(normal) + d2 * normal.cross(e1);
  return gradient.dot(a - m_camera.oC) > 0.;
}

void vpRimTracer::addPiece(vpContourSampler &sampler, std::size_t triangle, std::size_t entry, std::size_t exit) const
{
  vpModelView::Piece piece;
  setEnd(piece, 0, triangle, entry);
  setEnd(piece, 1, triangle, exit);
  piece.parameter = {{0., 1.}};
  piece.slides = true;
  sampler.add(piece);
}

void vpRimTracer::setEnd(vpModelView::Piece &piece, std::size_t end, std::size_t triangle, std::size_t side) const
{
  const vpModelTriangle &t = triangleAt(triangle);
  const std::size_t next = (side + 1) % 3;
  const double g0 = facing(triangle, side);
  const double g1 = facing(triangle, next);
  const double s = g0 / (g0 - g1);
  piece.position[end] = (1. - s) * m_model.vertices()[static_cast<std::size_t>(t.vertex[side])] +
                        s * m_model.vertices()[static_cast<std::size_t>(t.vertex[next])];
  const Eigen::Vector3d normal = ((1. - s) * m_model.normals()[static_cast<std::size_t>(t.normal[side])] +
                                  s * m_model.normals()[static_cast<std::size_t>(t.normal[next])])
                                     .normalized();
  // In the image a rim runs perpendicular to the surface's normal, which is smoother than the triangles' bits of curve.
  piece.direction[end] = normal.cross(piece.position[end] - m_camera.oC).normalized();
  piece.outward[end] = m_model.faces()[static_cast<std::size_t>(t.face)].oriented ? normal : Eigen::Vector3d::Zero();
}

END_VISP_NAMESPACE
