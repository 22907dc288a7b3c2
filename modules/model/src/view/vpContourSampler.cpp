// SPDX-License-Identifier: GPL-2.0-or-later
#include "view/vpContourSampler.h"

#include "view/vpCircleFrame.h"
#include <visp3/se3/vpExactNumber.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
// Surfaces nearer than this share of the diameter in front of an edge do not hide it: the edge lies on them.
const double hiddenTolerance = 0.005;
// Beside an edge, surface this close in depth (share of the diameter) is the surface of the edge.
const double sameSurfaceTolerance = 0.05;

template <typename T> T mix(const std::array<T, 2> &ends, double s)
{
  return ends[0] + (ends[1] - ends[0]) * s;
}
} // namespace

vpContourSampler::vpContourSampler(vpModelView &view, const vpViewCamera &camera, const vpModelViewOptions &options,
                                   const vpDepthProbe &depth)
    : m_view(view), m_camera(camera), m_options(options), m_depth(depth),
      m_high(camera.width - 1. - options.border, camera.height - 1. - options.border),
      m_tolerance(hiddenTolerance * view.model().diameter()), m_sideOffset(std::max(2.5, 1.5 / view.m_depth.scale))
{
  m_view.m_pieces.clear();
}

void vpContourSampler::add(const vpModelView::Piece &input)
{
  std::vector<vpModelView::Piece> &pieces = m_view.m_pieces;
  pieces.push_back(input);
  vpModelView::Piece &piece = pieces.back();
  if (!clipDepth(piece) || !clipImage(piece)) {
    pieces.pop_back();
    m_interrupted = true;
    return;
  }
  piece.joined = !m_interrupted && vpIsSame(piece.parameter[0], input.parameter[0]);
  m_interrupted = vpIsOther(piece.parameter[1], input.parameter[1]);
}

void vpContourSampler::cut(vpModelView::Piece &piece, double s0, double s1)
{
  if (vpIsZero(s0) && vpIsSame(s1, 1.)) {
    return;
  }
  const vpModelView::Piece whole = piece;
  const std::array<double, 2> s = {{s0, s1}};
  for (std::size_t k = 0; k < 2; ++k) {
    if (vpIsSame(s[k], static_cast<double>(k))) {
      continue;
    }
    piece.position[k] = mix(whole.position, s[k]);
    piece.direction[k] = mix(whole.direction, s[k]);
    piece.outward[k] = mix(whole.outward, s[k]);
    piece.depth[k] = mix(whole.depth, s[k]);
    piece.parameter[k] = mix(whole.parameter, s[k]);
  }
}

bool vpContourSampler::clipDepth(vpModelView::Piece &piece) const
{
  for (std::size_t k = 0; k < 2; ++k) {
    piece.depth[k] = m_camera.cRo.row(2).dot(piece.position[k]) + m_camera.cto.z();
  }
  const double farDistance = m_options.farDistance > 0. ? m_options.farDistance : std::numeric_limits<double>::max();
  const double rise = piece.depth[1] - piece.depth[0];
  double s0 = 0.;
  double s1 = 1.;
  for (const double limit : {m_options.nearDistance, farDistance}) {
    const double sign = vpIsSame(limit, farDistance) ? -1. : 1.;
    const bool out0 = sign * (piece.depth[0] - limit) < 0.;
    const bool out1 = sign * (piece.depth[1] - limit) < 0.;
    if (out0 && out1) {
      return false;
    }
    if (out0) {
      s0 = std::max(s0, (limit - piece.depth[0]) / rise);
    } else if (out1) {
      s1 = std::min(s1, (limit - piece.depth[0]) / rise);
    }
  }
  if (s0 >= s1) {
    return false;
  }
  cut(piece, s0, s1);
  return true;
}

bool vpContourSampler::clipImage(vpModelView::Piece &piece) const
{
  for (std::size_t k = 0; k < 2; ++k) {
    piece.pixel[k] = m_camera.project(m_camera.toCamera(piece.position[k]));
  }
  // Liang and Barsky: the share [s0, s1] of the image of the piece that is inside all four borders.
  const Eigen::Vector2d a = piece.pixel[0];
  const Eigen::Vector2d d = piece.pixel[1] - a;
  double s0 = 0.;
  double s1 = 1.;
  for (int axis = 0; axis < 2; ++axis) {
    const double low = m_options.border;
    if (vpIsZero(d[axis])) {
      if (a[axis] < low || a[axis] > m_high[axis]) {
        return false;
      }
      continue;
    }
    const double sLow = (low - a[axis]) / d[axis];
    const double sHigh = (m_high[axis] - a[axis]) / d[axis];
    s0 = std::max(s0, std::min(sLow, sHigh));
    s1 = std::min(s1, std::max(sLow, sHigh));
  }
  if (s0 >= s1) {
    return false;
  }
  if (s0 > 0. || s1 < 1.) {
    // Equal steps in the image are unequal ones in space.
    const double z0 = piece.depth[0];
    const double z1 = piece.depth[1];
    const auto inSpace = [z0, z1](double s) { return s * z0 / (s * z0 + (1. - s) * z1); };
    cut(piece, s0 > 0. ? inSpace(s0) : 0., s1 < 1. ? inSpace(s1) : 1.);
    piece.pixel = {{a + s0 * d, a + s1 * d}};
  }
  piece.length = (piece.pixel[1] - piece.pixel[0]).norm();
  return true;
}

bool vpContourSampler::isInside(const Eigen::Vector2d &pixel) const
{
  return pixel.x() >= m_options.border && pixel.x() <= m_high.x() && pixel.y() >= m_options.border &&
         pixel.y() <= m_high.y();
}

void vpContourSampler::sample(bool straight)
{
  const std::vector<vpModelView::Piece> &pieces = m_view.m_pieces;
  for (std::size_t first = 0; first < pieces.size();) {
    double total = pieces[first].length;
    std::size_t last = first + 1;
    while (last < pieces.size() && pieces[last].joined) {
      total += pieces[last++].length;
    }
    sampleRun(first, last, total, straight);
    first = last;
  }
  m_view.m_pieces.clear();
  m_interrupted = true;
}

void vpContourSampler::sampleRun(std::size_t first, std::size_t last, double total, bool straight)
{
  // Less than a step of contour tells less than the points of other edges that are searched across it.
  if (total < 0.75 * m_options.sampleStep) {
    return;
  }
  const double count = std::max(1., std::floor(total / m_options.sampleStep));
  const double spacing = total / count;
  double next = 0.5 * spacing;
  double begin = 0.;
  bool open = false;
  for (std::size_t i = first; i < last; ++i) {
    const vpModelView::Piece &piece = m_view.m_pieces[i];
    for (; next <= begin + piece.length; next += spacing) {
      if (!open) {
        vpContour contour;
        contour.first = static_cast<int>(m_view.m_points.size());
        contour.straight = straight;
        contour.step = spacing;
        m_view.m_contours.push_back(contour);
      }
      vpContour &contour = m_view.m_contours.back();
      open = emit(piece, (next - begin) / piece.length, (contour.count + 0.5) * spacing);
      contour.count += open ? 1 : 0;
      if (contour.count == 0) {
        m_view.m_contours.pop_back();
      }
    }
    begin += piece.length;
  }
}

// False where the point is out of sight, though its chord is not.
bool vpContourSampler::place(vpControlPoint &point, const vpModelView::Piece &piece, double s, double t) const
{
  point.parameter = mix(piece.parameter, t);
  if (piece.circle == nullptr) {
    point.position = mix(piece.position, t);
    point.direction = mix(piece.direction, t).normalized();
    point.pixel = mix(piece.pixel, s);
    return true;
  }
  vpCircleFrame(*piece.circle).place(point.parameter, point.position, point.direction);
  point.pixel = m_camera.project(m_camera.toCamera(point.position));
  return isInside(point.pixel);
}

bool vpContourSampler::emit(const vpModelView::Piece &piece, double s, double arcLength)
{
  const double z0 = piece.depth[0];
  const double z1 = piece.depth[1];
  const double t = s * z0 / (s * z0 + (1. - s) * z1);
  vpControlPoint point;
  if (!place(point, piece, s, t)) {
    return false;
  }
  const Eigen::Vector3d cX = m_camera.toCamera(point.position);
  if (m_depth.isCovered(point.pixel, cX.z() - m_tolerance)) {
    return false;
  }
  // The plane through the camera's centre, the point and its direction cuts the image in the edge's tangent.
  const Eigen::Vector3d plane = cX.cross(m_camera.cRo * point.direction);
  point.normal = Eigen::Vector2d(plane.x() / m_camera.px, plane.y() / m_camera.py);
  const double length = point.normal.norm() * m_camera.px;
  if (!(length > 1e-3 * cX.norm())) {
    return false; // Seen end-on, its direction in the image means nothing.
  }
  point.normal /= point.normal.norm();
  orient(point, cX, mix(piece.outward, t), piece.innerEdge);
  point.slides = piece.slides;
  point.contour = static_cast<int>(m_view.m_contours.size()) - 1;
  point.arcLength = arcLength;
  point.edge = piece.edge;
  m_view.m_points.push_back(point);
  return true;
}

void vpContourSampler::orient(vpControlPoint &point, const Eigen::Vector3d &cX, const Eigen::Vector3d &outward,
                              bool innerEdge) const
{
  point.side = 1.;
  if (innerEdge) {
    point.kind = vpEdgeKind::INNER;
    return;
  }
  if (outward.isZero()) {
    orientByDepth(point, cX.z());
    return;
  }
  const Eigen::Vector3d away = m_camera.cRo * outward;
  const Eigen::Vector2d shift(m_camera.px * (away.x() * cX.z() - away.z() * cX.x()),
                              m_camera.py * (away.y() * cX.z() - away.z() * cX.y()));
  if (shift.dot(point.normal) < 0.) {
    point.normal = -point.normal;
    point.side = -1.;
  }
  const bool background = vpIsZero(m_depth.at(point.pixel + m_sideOffset * point.normal));
  point.kind = background ? vpEdgeKind::SILHOUETTE : vpEdgeKind::INNER;
}

void vpContourSampler::orientByDepth(vpControlPoint &point, double depth) const
{
  point.kind = vpEdgeKind::INNER;
  if (!m_depth.exists()) {
    return;
  }
  const double same = depth + sameSurfaceTolerance * m_view.model().diameter();
  const double ahead = m_depth.at(point.pixel + m_sideOffset * point.normal);
  const double behind = m_depth.at(point.pixel - m_sideOffset * point.normal);
  const bool surfaceAhead = ahead > 0. && ahead < same;
  const bool surfaceBehind = behind > 0. && behind < same;
  if (surfaceAhead == surfaceBehind) {
    return;
  }
  if (surfaceAhead) {
    point.normal = -point.normal;
    point.side = -1.;
  }
  if (vpIsZero((surfaceAhead ? behind : ahead))) {
    point.kind = vpEdgeKind::SILHOUETTE;
  }
}

END_VISP_NAMESPACE
