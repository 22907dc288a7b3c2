// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpModelView.h>

#include "view/runBoth.h"
#include "view/vpContourSampler.h"
#include "view/vpCurves.h"
#include "view/vpDepthProbe.h"
#include "view/vpModelTopology.h"
#include "view/vpRimTracer.h"
#include "view/vpViewCamera.h"
#include "view/vpTextureContours.h"

#include <visp3/core/vpException.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Of a mesh that is worth a second thread.
const std::size_t manyTriangles = 5000;

void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpModelViewOptions::%s is %g, it must be %s", member, value, range);
  }
}

// Area of the projected polygon, square pixels; the camera sees all of it or the area is no use and counts as large.
double projectedArea(const vpTrackedModel &model, const vpModelFace &face, const vpViewCamera &camera,
                     double nearDistance)
{
  double twice = 0.;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const std::size_t j = (i + 1) % face.corners.size();
    const Eigen::Vector3d a = camera.toCamera(model.vertices()[static_cast<std::size_t>(face.corners[i])]);
    const Eigen::Vector3d b = camera.toCamera(model.vertices()[static_cast<std::size_t>(face.corners[j])]);
    if (a.z() < nearDistance || b.z() < nearDistance) {
      return HUGE_VAL;
    }
    const Eigen::Vector2d p = camera.project(a);
    const Eigen::Vector2d q = camera.project(b);
    twice += p.x() * q.y() - q.x() * p.y();
  }
  return 0.5 * std::fabs(twice);
}

// What ViSP's hidden-face test does: the angle at the face's centre, with hysteresis, and the level of detail.
void findFacesSeen(const vpTrackedModel &model, const vpViewCamera &camera, const vpModelViewOptions &options,
                   std::vector<char> &seen)
{
  seen.resize(model.faces().size(), 0);
  const double appear = std::cos(options.appearAngle * M_PI / 180.);
  const double disappear = std::cos(options.disappearAngle * M_PI / 180.);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const vpModelFace &face = model.faces()[i];
    if (face.planar && face.oriented && !options.allEdges) {
      const Eigen::Vector3d toCamera = camera.oC - face.centre;
      seen[i] = face.normal.dot(toCamera) > (seen[i] ? disappear : appear) * toCamera.norm();
    } else {
      seen[i] = 1;
    }
    if (seen[i] && i < options.details.size() && options.details[i].enabled && !face.corners.empty()) {
      seen[i] = projectedArea(model, face, camera, options.nearDistance) >= options.details[i].minPolygonArea;
    }
  }
}
} // namespace

void vpModelViewOptions::check() const
{
  require(sampleStep >= 0.5, "sampleStep", sampleStep, "at least 0.5 pixels");
  require(appearAngle > 0. && appearAngle <= 90., "appearAngle", appearAngle, "in (0, 90] degrees");
  require(disappearAngle >= appearAngle && disappearAngle <= 90., "disappearAngle", disappearAngle,
          "in [appearAngle, 90] degrees");
  require(nearDistance > 0., "nearDistance", nearDistance, "above 0 m");
  require(vpIsZero(farDistance) || farDistance > nearDistance, "farDistance", farDistance, "0 or above nearDistance");
  require(border >= 0., "border", border, "at least 0 pixels");
  require(visibilitySize >= 16, "visibilitySize", visibilitySize, "at least 16 pixels");
}

vpModelView::vpModelView(const std::shared_ptr<const vpTrackedModel> &model)
    : m_model(model), m_topology(std::make_shared<vpModelTopology>(*model)),
      m_texture(std::make_shared<vpTextureSource>())
{
}

int vpModelView::edgeNames() const
{
  return vpCurves::names(*m_model) + (m_hasTextureEdges ? static_cast<int>(textureEdges().size()) : 0);
}

const std::vector<vpTextureEdge> &vpModelView::textureEdges() const
{
  return m_texture->edges(*m_model);
}

int vpModelView::textureEdgeOf(const vpControlPoint &point) const
{
  return std::max(point.edge - vpCurves::names(*m_model), -1);
}

// Looks into the depth buffer where the object's centre was when it was drawn.
vpDepthProbe vpModelView::depthProbe(const vpViewCamera &camera) const
{
  const Eigen::Vector3d centre = m_model->centre();
  const auto at = [&](const vpHomogeneousMatrix &cMo) {
    return Eigen::Vector3d(cMo[0][0] * centre.x() + cMo[0][1] * centre.y() + cMo[0][2] * centre.z() + cMo[0][3],
                           cMo[1][0] * centre.x() + cMo[1][1] * centre.y() + cMo[1][2] * centre.z() + cMo[1][3],
                           cMo[2][0] * centre.x() + cMo[2][1] * centre.y() + cMo[2][2] * centre.z() + cMo[2][3]);
  };
  if (!m_hasDepth) {
    return vpDepthProbe(nullptr);
  }
  const Eigen::Vector3d now = at(m_cMo);
  const Eigen::Vector3d then = at(m_depthPose);
  if (!(now.z() > 0.) || !(then.z() > 0.)) {
    return vpDepthProbe(&m_depth);
  }
  return vpDepthProbe(&m_depth, camera.project(now) - camera.project(then), now.z() - then.z());
}

void vpModelView::drawDepth(const vpCameraParameters &cam, unsigned int imageWidth, unsigned int imageHeight,
                            const vpModelViewOptions &options, vpModelRenderer &renderer)
{
  m_depthPose = m_cMo;
  vpRenderOptions depthOptions;
  depthOptions.maxSize = options.visibilitySize;
  depthOptions.scale = 0.5;
  depthOptions.nearDistance = options.nearDistance;
  renderer.render(m_cMo, cam, imageWidth, imageHeight, depthOptions, m_depth);
}

void vpModelView::compute(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
                          unsigned int imageHeight, const vpModelViewOptions &options, vpModelRenderer *renderer,
                          bool keepDepth)
{
  m_points.clear();
  m_contours.clear();
  const vpViewCamera camera(cMo, cam, imageWidth, imageHeight);
  findFacesSeen(*m_model, camera, options, m_facesSeen);

  m_cMo = cMo;
  const bool hadDepth = m_hasDepth;
  m_hasDepth = renderer != nullptr && !m_model->isConvex();
  const bool draws = m_hasDepth && !(keepDepth && hadDepth);
  const bool hasRims = !m_model->smoothTriangles().empty();
  vpRimTracer tracer(*this, *m_topology, camera);
  const auto draw = [&] { drawDepth(cam, imageWidth, imageHeight, options, *renderer); };
  if (draws && m_model->smoothTriangles().size() >= manyTriangles && renderer->mayChangeThread()) {
    vpRunBoth(draw, [&] { tracer.trace(); });
  } else {
    if (draws) {
      draw();
    }
    if (hasRims) {
      tracer.trace();
    }
  }
  vpContourSampler sampler(*this, camera, options, depthProbe(camera));
  const vpCurves curves(*m_model, *m_topology, m_facesSeen, camera, options);
  curves.addEdges(sampler);
  curves.addLimbs(sampler);
  curves.addCircles(sampler);
  if (hasRims) {
    tracer.sample(sampler);
  }
  m_hasTextureEdges = options.textureEdges && !textureEdges().empty();
  if (m_hasTextureEdges) {
    vpTextureContours(*this, camera, options).add(textureEdges(), vpCurves::names(*m_model), sampler);
  }
  m_hasSlidingRims = !m_model->smoothTriangles().empty() || !m_model->cylinders().empty();
}

END_VISP_NAMESPACE
