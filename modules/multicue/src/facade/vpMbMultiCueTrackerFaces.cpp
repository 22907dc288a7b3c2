// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// How far from a face's plane a point is on it, as a share of the object's diameter.
const double onFace = 0.01;

Eigen::Vector3d toEigen(const vpPoint &point)
{
  return Eigen::Vector3d(point.get_oX(), point.get_oY(), point.get_oZ());
}

void setMember(std::set<std::string> &names, const std::string &name, bool isMember)
{
  if (isMember) {
    names.insert(name);
  } else {
    names.erase(name);
  }
}

// A flat face of a .cao or .wrl file.
class FlatFace
{
public:
  FlatFace(const vpTrackedModel &model, const vpModelFace &face)
      : m_normal(face.normal), m_centre(face.centre), m_distance(onFace * model.diameter())
  {
    face.normal.cwiseAbs().maxCoeff(&m_across);
    for (const int corner : face.corners) {
      m_corners.push_back(inPlane(model.vertices()[static_cast<std::size_t>(corner)]));
    }
  }

  bool contains(const Eigen::Vector3d &position) const
  {
    if (std::fabs(m_normal.dot(position - m_centre)) > m_distance) {
      return false;
    }
    // A ray from the point crosses the boundary an odd number of times.
    const Eigen::Vector2d p = inPlane(position);
    bool inside = false;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
      const Eigen::Vector2d &a = m_corners[i];
      const Eigen::Vector2d &b = m_corners[(i + 1) % m_corners.size()];
      const bool crosses = (a.y() > p.y()) != (b.y() > p.y());
      if (crosses && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
        inside = !inside;
      }
    }
    return inside;
  }

private:
  // Without the coordinate that the plane is least parallel to.
  Eigen::Vector2d inPlane(const Eigen::Vector3d &position) const
  {
    return Eigen::Vector2d(position[(m_across + 1) % 3], position[(m_across + 2) % 3]);
  }

  Eigen::Vector3d m_normal;
  Eigen::Vector3d m_centre;
  double m_distance;
  Eigen::Index m_across = 0;
  std::vector<Eigen::Vector2d> m_corners;
};
} // namespace

void vpMbMultiCueTracker::setUseEdgeTracking(const std::string &name, const bool &useEdgeTracking)
{
  setMember(m_impl->untracked.edges, name, !useEdgeTracking);
  m_impl->updateDetails();
}

void vpMbMultiCueTracker::setUseKltTracking(const std::string &name, const bool &useKltTracking)
{
  setMember(m_impl->untracked.points, name, !useKltTracking);
  m_impl->updatePointFilter();
}

void vpMbMultiCueTracker::Impl::updatePointFilter()
{
  vpPointCue *points = m_engine.cues.pointPart().points();
  if (points == nullptr) {
    return;
  }
  std::vector<FlatFace> excluded;
  if (m_engine.looks.pointer() && !untracked.points.empty()) {
    for (const vpModelFace &face : m_engine.looks.model().faces()) {
      if (!face.corners.empty() && untracked.points.count(face.name) > 0) {
        excluded.emplace_back(m_engine.looks.model(), face);
      }
    }
  }
  if (excluded.empty()) {
    if (m_filtersPoints) {
      points->setSurfaceFilter({});
    }
    m_filtersPoints = false;
    return;
  }
  m_filtersPoints = true;
  points->setSurfaceFilter([excluded](const Eigen::Vector3d &position) {
    return std::none_of(excluded.begin(), excluded.end(),
                        [&position](const FlatFace &face) { return face.contains(position); });
  });
}

void vpMbMultiCueTracker::addCircle(const vpPoint &P1, const vpPoint &P2, const vpPoint &P3, double r,
                                    const std::string &name)
{
  m_impl->engine().looks.requireModel();
  vpTrackedModelBuilder parts = *m_impl->parts;
  parts.addCircle(toEigen(P1), toEigen(P2), toEigen(P3), r, name);
  vpTrackedModel loaded = parts.build(modelFileName);
  m_impl->parts = std::make_unique<vpTrackedModelBuilder>(std::move(parts));
  m_impl->engine().setModel(std::move(loaded));
  m_impl->displayView.reset();
  m_impl->updateDetails();
  m_impl->updatePointFilter();
}

END_VISP_NAMESPACE
