// SPDX-License-Identifier: GPL-2.0-or-later
#include "view/vpCurves.h"

#include "view/vpCircleFrame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

vpCurves::vpCurves(const vpTrackedModel &model, const vpModelTopology &topology, const std::vector<char> &facesSeen,
                   const vpViewCamera &camera, const vpModelViewOptions &options)
    : m_model(model), m_topology(topology), m_facesSeen(facesSeen), m_camera(camera), m_options(options)
{
}

int vpCurves::names(const vpTrackedModel &model)
{
  return static_cast<int>(model.edges().size() + 2 * model.cylinders().size() + model.circles().size());
}

vpCurves::EdgeSight vpCurves::look(const vpModelEdge &edge) const
{
  EdgeSight sight;
  if (edge.faceCount == 0) {
    sight.seen = true;
    return sight;
  }
  int seen = 0;
  bool known = true;
  for (int slot = edge.firstFace; slot < edge.firstFace + edge.faceCount; ++slot) {
    const std::size_t face = static_cast<std::size_t>(m_model.edgeFaces()[static_cast<std::size_t>(slot)]);
    if (m_facesSeen[face]) {
      ++seen;
      sight.outward = -m_topology.intoFace()[static_cast<std::size_t>(slot)];
    }
    known = known && m_model.faces()[face].planar && m_model.faces()[face].oriented;
  }
  sight.seen = seen > 0;
  sight.inner = known && seen > 1;
  if (!known || seen > 1) {
    sight.outward.setZero();
  }
  return sight;
}

bool vpCurves::isTracked(int face) const
{
  const std::size_t index = static_cast<std::size_t>(face);
  return face < 0 || index >= m_options.details.size() || m_options.details[index].tracked;
}

// An edge is, as long as one of the faces that show it is.
bool vpCurves::isTracked(const vpModelEdge &edge) const
{
  if (m_options.details.empty() || edge.faceCount == 0) {
    return isTracked(edge.line);
  }
  for (int slot = edge.firstFace; slot < edge.firstFace + edge.faceCount; ++slot) {
    const int face = m_model.edgeFaces()[static_cast<std::size_t>(slot)];
    if (m_facesSeen[static_cast<std::size_t>(face)] && isTracked(face)) {
      return true;
    }
  }
  return false;
}

bool vpCurves::isLongEnough(const vpModelEdge &edge) const
{
  if (m_options.details.empty()) {
    return true;
  }
  const Eigen::Vector3d a = m_camera.toCamera(m_model.vertices()[static_cast<std::size_t>(edge.vertex[0])]);
  const Eigen::Vector3d b = m_camera.toCamera(m_model.vertices()[static_cast<std::size_t>(edge.vertex[1])]);
  if (a.z() < m_options.nearDistance || b.z() < m_options.nearDistance) {
    return true;
  }
  const double length = (m_camera.project(a) - m_camera.project(b)).norm();
  const auto suffices = [this, length](int face) {
    const std::size_t index = static_cast<std::size_t>(face);
    return index >= m_options.details.size() || !m_options.details[index].enabled ||
           length >= m_options.details[index].minLineLength;
  };
  if (edge.faceCount == 0) {
    return edge.line < 0 || suffices(edge.line);
  }
  for (int slot = edge.firstFace; slot < edge.firstFace + edge.faceCount; ++slot) {
    if (suffices(m_model.edgeFaces()[static_cast<std::size_t>(slot)])) {
      return true;
    }
  }
  return false;
}

void vpCurves::addEdges(vpContourSampler &sampler) const
{
  for (const vpModelTopology::Chain &chain : m_topology.chains()) {
    for (int i = chain.first; i < chain.first + chain.count; ++i) {
      const vpModelTopology::Link &link = m_topology.links()[static_cast<std::size_t>(i)];
      const vpModelEdge &edge = m_model.edges()[static_cast<std::size_t>(link.edge)];
      const EdgeSight sight = look(edge);
      if (!sight.seen || !isTracked(edge) || !isLongEnough(edge)) {
        sampler.interrupt();
        continue;
      }
      const std::size_t from = link.reversed ? 1 : 0;
      const Eigen::Vector3d &a = m_model.vertices()[static_cast<std::size_t>(edge.vertex[from])];
      const Eigen::Vector3d &b = m_model.vertices()[static_cast<std::size_t>(edge.vertex[1 - from])];
      vpModelView::Piece piece;
      piece.position = {{a, b}};
      // The edge's own direction, whichever way the chain is walked: contrasts are remembered with its sign.
      const Eigen::Vector3d direction = (link.reversed ? a - b : b - a).normalized();
      piece.direction = {{direction, direction}};
      piece.outward = {{sight.outward, sight.outward}};
      piece.innerEdge = sight.inner;
      piece.parameter = {{static_cast<double>(from), static_cast<double>(1 - from)}};
      piece.edge = link.edge;
      sampler.add(piece);
    }
    sampler.sample(chain.count == 1);
  }
}

void vpCurves::addLimbs(vpContourSampler &sampler) const
{
  int name = static_cast<int>(m_model.edges().size());
  for (const vpModelCylinder &cylinder : m_model.cylinders()) {
    const Eigen::Vector3d axis = (cylinder.axis[1] - cylinder.axis[0]).normalized();
    const Eigen::Vector3d toCamera = m_camera.oC - cylinder.axis[0];
    const Eigen::Vector3d across = toCamera - axis * axis.dot(toCamera);
    const double distance = across.norm();
    if (!(distance > cylinder.radius) || !isTracked(cylinder.face)) {
      name += 2; // Seen from inside or along its axis, a cylinder has no limbs.
      continue;
    }
    // The normal of a limb is perpendicular to the line of sight: cos = radius / distance from the axis.
    const double cosine = cylinder.radius / distance;
    const double sine = std::sqrt(1. - cosine * cosine);
    const Eigen::Vector3d x = across / distance;
    const Eigen::Vector3d y = axis.cross(x);
    for (const double side : {-1., 1.}) {
      const Eigen::Vector3d normal = cosine * x + side * sine * y;
      vpModelView::Piece piece;
      for (std::size_t k = 0; k < 2; ++k) {
        piece.position[k] = cylinder.axis[k] + cylinder.radius * normal;
        piece.direction[k] = axis;
        piece.outward[k] = normal;
        piece.parameter[k] = static_cast<double>(k);
      }
      piece.edge = name++;
      piece.slides = true;
      sampler.add(piece);
      sampler.sample(true);
    }
  }
}

void vpCurves::addCircles(vpContourSampler &sampler) const
{
  int name = static_cast<int>(m_model.edges().size() + 2 * m_model.cylinders().size());
  for (const vpModelCircle &circle : m_model.circles()) {
    const int edge = name++;
    const double z = m_camera.toCamera(circle.centre).z();
    const bool isSeen = m_facesSeen[static_cast<std::size_t>(circle.face)] != 0;
    if (!isSeen || !isTracked(circle.face) || z < m_options.nearDistance) {
      continue;
    }
    // Chords of four pixels are as good as the circle when it comes to what the image border or a distance cuts off.
    const double around = 2. * M_PI * circle.radius * m_camera.px / z;
    const int count = static_cast<int>(std::min(std::max(around / 4., 32.), 512.));
    const vpCircleFrame frame(circle);
    vpModelView::Piece piece;
    piece.edge = edge;
    piece.circle = &circle;
    piece.outward = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}};
    for (int i = 0; i <= count; ++i) {
      piece.parameter[1] = static_cast<double>(i) / count;
      frame.place(piece.parameter[1], piece.position[1], piece.direction[1]);
      if (i > 0) {
        sampler.add(piece);
      }
      piece.position[0] = piece.position[1];
      piece.direction[0] = piece.direction[1];
      piece.parameter[0] = piece.parameter[1];
    }
    sampler.sample(false);
  }
}

END_VISP_NAMESPACE
