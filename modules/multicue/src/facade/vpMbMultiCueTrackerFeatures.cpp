// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpDistortedPoint.h"
#include "facade/vpGradientAngle.h"
#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpDisplay.h>

BEGIN_VISP_NAMESPACE

namespace {
// Where ViSP's vpMbGenericTracker has the number of a point written, from the point, pixels.
const double numberOffset = 7.;

// Cues whose last minimisation went through have a weight for each row.
bool hasWeights(const vpCueFusion::Part &part)
{
  return part.weights.size() == part.block.rows.size();
}

// Nothing where the image has no display.
void drawArrow(const vpImage<unsigned char> &I, const vpImagePoint &from, const Eigen::Vector2d &vector,
               const vpColor &color, unsigned int thickness)
{
  vpDisplay::displayArrow(I, from, from + vpImagePoint(vector.y(), vector.x()), color, 4, 2, thickness);
}

// Of an edge at a control point, unit length: the pose may have moved since the view that the point is of.
Eigen::Vector2d imageDirection(const vpControlPoint &point, const vpHomogeneousMatrix &cMo,
                               const vpCameraParameters &cam)
{
  Eigen::Matrix3d cRo;
  Eigen::Vector3d cTo;
  for (unsigned int i = 0; i < 3; ++i) {
    cRo.row(i) << cMo[i][0], cMo[i][1], cMo[i][2];
    cTo[i] = cMo[i][3];
  }
  const Eigen::Vector3d place = cRo * point.position + cTo;
  const Eigen::Vector3d direction = cRo * point.direction;
  const Eigen::Vector2d along(cam.get_px() * (direction.x() * place.z() - direction.z() * place.x()),
                              cam.get_py() * (direction.y() * place.z() - direction.z() * place.y()));
  return along.normalized();
}
} // namespace

vpColVector vpMbMultiCueTracker::getError() const
{
  std::vector<double> errors;
  for (std::size_t i = 0; i < m_impl->engine().minimiser.fusion().size(); ++i) {
    const vpCueFusion::Part &part = m_impl->engine().minimiser.fusion()[i];
    for (std::size_t row = 0; hasWeights(part) && row < part.block.rows.size(); ++row) {
      errors.push_back(part.block.rows[row].error);
    }
  }
  return vpColVector(errors);
}

vpColVector vpMbMultiCueTracker::getRobustWeights() const
{
  std::vector<double> weights;
  for (std::size_t i = 0; i < m_impl->engine().minimiser.fusion().size(); ++i) {
    const vpCueFusion::Part &part = m_impl->engine().minimiser.fusion()[i];
    if (hasWeights(part)) {
      weights.insert(weights.end(), part.weights.begin(), part.weights.end());
    }
  }
  return vpColVector(weights);
}

std::vector<vpMbMultiCueTracker::Impl::Feature> vpMbMultiCueTracker::Impl::featuresForDisplay() const
{
  std::vector<Feature> features;
  std::vector<vpCueFeature> own;
  for (std::size_t i = 0; i < m_engine.minimiser.fusion().size(); ++i) {
    const vpCueFusion::Part &part = m_engine.minimiser.fusion()[i];
    part.cue->getFeatures(m_tracker.m_cMo, part.weights, own);
    for (std::size_t k = 0; k < own.size(); ++k) {
      Feature feature;
      feature.place = vpDistortedPoint::of(Eigen::Vector2d(own[k].u, own[k].v), m_tracker.m_cam);
      feature.state = own[k].state;
      feature.id = part.type == KLT_TRACKER ? m_engine.cues.pointPart().points()->matches()[k].id : -1;
      features.push_back(feature);
    }
  }
  return features;
}

std::vector<std::vector<double>> vpMbMultiCueTracker::getFeaturesForDisplay()
{
  std::vector<std::vector<double>> result;
  for (const Impl::Feature &feature : m_impl->featuresForDisplay()) {
    const double row = feature.place.get_i();
    const double column = feature.place.get_j();
    if (feature.id < 0) {
      result.push_back({0., row, column, static_cast<double>(feature.state)});
    } else if (feature.state == vpFeatureState::GOOD || feature.state == vpFeatureState::OUTLIER) {
      result.push_back({1., row, column, row + numberOffset, column + numberOffset, static_cast<double>(feature.id)});
    }
  }
  return result;
}

std::map<int, vpImagePoint> vpMbMultiCueTracker::getKltImagePointsWithId() const
{
  std::map<int, vpImagePoint> points;
  const vpPointCue *cue = m_impl->engine().cues.pointPart().points();
  if (cue != nullptr) {
    for (const vpPointCue::Match &match : cue->matches()) {
      if (match.found) {
        points[match.id] = vpDistortedPoint::of(match.pixel, m_cam);
      }
    }
  }
  return points;
}

void vpMbMultiCueTracker::computeProjectionError()
{
  projectionError = computeProjError ? projectionError : 90.;
}

// Where the edges were found, as ViSP's trackers look at their moving edges.
void vpMbMultiCueTracker::Impl::updateProjectionError(const vpCueFrame &image)
{
  if (!m_tracker.computeProjError) {
    return;
  }
  const vpCueFusion::Part *part = m_engine.minimiser.fusion().find(EDGE_TRACKER);
  if (part == nullptr) {
    m_tracker.projectionError = m_tracker.computeCurrentProjectionError(image.gray(), m_tracker.m_cMo, image.camera());
    return;
  }
  std::vector<vpCueFeature> features;
  m_engine.cues.edges().getFeatures(m_tracker.m_cMo, part->weights, features);
  vpGradientAngle::Mean mean(image.gray(), m_tracker.m_SobelX, m_tracker.m_SobelY);
  const std::vector<vpEdgeCue::Match> &matches = m_engine.cues.edges().matches();
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (matches[i].count > 0 && features[i].state == vpFeatureState::GOOD) {
      const Eigen::Vector2d along = imageDirection(matches[i].point, m_tracker.m_cMo, image.camera());
      const Eigen::Vector2d normal(-along.y(), along.x());
      const Eigen::Vector2d gradient = mean.add(features[i].u, features[i].v, normal);
      if (m_tracker.m_projectionErrorDisplay) {
        const vpImagePoint place(features[i].v, features[i].u);
        const double towards = gradient.dot(normal) < 0. ? -1. : 1.; // An edge has two normals.
        const double length = m_tracker.m_projectionErrorDisplayLength;
        drawArrow(image.gray(), place, length * normal, vpColor::blue, m_tracker.m_projectionErrorDisplayThickness);
        drawArrow(image.gray(), place, towards * length * gradient.normalized(), vpColor::red,
                  m_tracker.m_projectionErrorDisplayThickness);
      }
    }
  }
  m_tracker.projectionError = mean.degrees();
}

END_VISP_NAMESPACE
