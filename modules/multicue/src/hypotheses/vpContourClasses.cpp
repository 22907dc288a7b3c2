// SPDX-License-Identifier: GPL-2.0-or-later
#include "hypotheses/vpContourClasses.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// A mean can follow half a turn of a curve; longer ones move in parts.
const double longestTurn = M_PI;
// Control points this many steps apart are neighbours, with a masked one between them.
const double neighbourSteps = 2.5;

double turnBetween(const vpControlPoint &a, const vpControlPoint &b)
{
  return std::fabs(std::atan2(a.normal.x() * b.normal.y() - a.normal.y() * b.normal.x(), a.normal.dot(b.normal)));
}
} // namespace

void vpContourClasses::addContour(const std::vector<vpEdgeCue::Match> &, int first, int end,
                                  vpEdgeClustering::Shape shape, double turn)
{
  Contour contour;
  contour.first = first;
  contour.count = end - first;
  m_contours.push_back(contour);
  m_forms.push_back({shape, turn});
}

int vpContourClasses::splitCurve(const std::vector<vpEdgeCue::Match> &matches, int first, int end)
{
  double turn = 0.;
  int next = first + 1;
  for (; next < end; ++next) {
    const double more =
        turnBetween(matches[static_cast<std::size_t>(next - 1)].point, matches[static_cast<std::size_t>(next)].point);
    if (turn + more > longestTurn) {
      break;
    }
    turn += more;
  }
  addContour(matches, first, next, vpEdgeClustering::Shape::OPEN_CURVE, turn);
  return next;
}

void vpContourClasses::split(const vpEdgeCue &edges, const vpModelView &view)
{
  m_contours.clear();
  m_forms.clear();
  const std::vector<vpEdgeCue::Match> &matches = edges.matches();
  const int count = static_cast<int>(matches.size());
  for (int first = 0; first < count;) {
    const vpControlPoint &begin = matches[static_cast<std::size_t>(first)].point;
    int end = first + 1;
    while (end < count && matches[static_cast<std::size_t>(end)].point.contour == begin.contour) {
      ++end;
    }
    const vpContour &contour = view.contours()[static_cast<std::size_t>(begin.contour)];
    const vpControlPoint &last = matches[static_cast<std::size_t>(end - 1)].point;
    if (contour.straight) {
      addContour(matches, first, end, vpEdgeClustering::Shape::STRAIGHT, 0.);
    } else if (end - first > 8 && (last.pixel - begin.pixel).norm() < neighbourSteps * contour.step) {
      addContour(matches, first, end, vpEdgeClustering::Shape::CLOSED_CURVE, 2. * M_PI);
    } else {
      for (int part = first; part < end;) {
        part = splitCurve(matches, part, end);
      }
    }
    first = end;
  }
}

void vpContourClasses::cluster(const vpEdgeCue &edges, Contour &contour, vpEdgeClustering::Shape shape, double turn,
                               double lambda)
{
  m_clustering.begin(shape, turn);
  std::array<double, vpEdgeClustering::maxClasses> offsets{};
  for (int i = 0; i < contour.count; ++i) {
    const vpEdgeCue::Match &match = edges.matches()[static_cast<std::size_t>(contour.first + i)];
    const int count = std::min(match.count, vpEdgeClustering::maxClasses);
    for (int j = 0; j < count; ++j) {
      offsets[static_cast<std::size_t>(j)] = edges.candidates()[static_cast<std::size_t>(match.first + j)].offset;
    }
    m_clustering.add(match.point.arcLength, offsets.data(), count);
  }
  m_clustering.compute();
  m_clustering.drawWeights(lambda, m_weights);
  contour.firstClass = static_cast<int>(m_classes.size());
  contour.classes = static_cast<int>(m_clustering.classes().size());
  m_most = std::max(m_most, contour.classes);
  for (int label = 0; label < contour.classes; ++label) {
    const std::size_t index = static_cast<std::size_t>(label);
    m_classes.emplace_back();
    m_classes.back().size = m_clustering.classes()[index].size;
    m_classes.back().residue = m_clustering.classes()[index].residue;
    m_classes.back().weight = m_weights[index];
    for (int i = 0; i < contour.count; ++i) {
      const int member = m_clustering.member(label, i);
      const std::size_t match = static_cast<std::size_t>(contour.first + i);
      m_members[index][match] = member < 0 ? vpEdgeCue::NO_ROW : member;
      m_displacements[index][match] = m_clustering.displacement(label, edges.matches()[match].point.arcLength);
    }
  }
}

void vpContourClasses::linearise(const vpEdgeCue &edges, const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &toCamera)
{
  const double px = edges.camera().get_px();
  for (int label = 0; label < m_most; ++label) {
    const std::vector<int> &members = m_members[static_cast<std::size_t>(label)];
    edges.residuals(cMo, members, m_block);
    std::size_t row = 0;
    for (const Contour &contour : m_contours) {
      if (label >= contour.classes) {
        continue; // Its matches have no rows.
      }
      vpPoseMatrix6 A = vpPoseMatrix6::Zero();
      vpPoseTangent b = vpPoseTangent::Zero();
      double c = 0.;
      for (int i = contour.first; i < contour.first + contour.count; ++i) {
        if (members[static_cast<std::size_t>(i)] == vpEdgeCue::NO_ROW) {
          continue;
        }
        const vpResidual &r = m_block.rows[row++];
        for (int k = 0; k < 6; ++k) {
          A.col(k) += r.jacobian(k) * r.jacobian;
        }
        b += r.error * r.jacobian;
        c += r.error * r.error;
      }
      Class &found = m_classes[static_cast<std::size_t>(contour.firstClass + label)];
      found.A = px * px * toCamera.transpose().lazyProduct(vpPoseMatrix6(A.lazyProduct(toCamera)));
      found.b = px * px * toCamera.transpose() * b;
      found.c = px * px * c;
    }
  }
}

double vpContourClasses::difference(const vpPoseTangent &y1, const vpPoseTangent &y2) const
{
  const vpPoseTangent d = y1 - y2;
  return std::sqrt(std::max(d.dot(m_meanA * d), 0.));
}

void vpContourClasses::compute(const vpEdgeCue &edges, const vpModelView &view, const vpHomogeneousMatrix &cMo,
                               const vpPoseMatrix6 &toCamera, double lambda)
{
  split(edges, view);
  m_classes.clear();
  m_most = 0;
  for (std::size_t label = 0; label < m_members.size(); ++label) {
    m_members[label].assign(edges.matches().size(), vpEdgeCue::NO_ROW);
    m_displacements[label].resize(edges.matches().size());
  }
  for (std::size_t i = 0; i < m_contours.size(); ++i) {
    cluster(edges, m_contours[i], m_forms[i].shape, m_forms[i].turn, lambda);
  }
  linearise(edges, cMo, toCamera);
  m_meanA.setZero();
  double size = 0.;
  for (const Class &c : m_classes) {
    m_meanA += c.A;
    size += c.size;
  }
  m_meanA /= std::max(size, 1.);
}

END_VISP_NAMESPACE
