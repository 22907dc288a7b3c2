// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpDistortedPoint.h"
#include "facade/vpGradientAngle.h"
#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpDisplay.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/se3/vpPoseExponential.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Lines are drawn in bits of this length at the longest, so that hidden parts and lens distortion show.
const double displayStep = 6.; // Pixels.

vpColor colorOf(vpFeatureState state)
{
  switch (state) {
  case vpFeatureState::GOOD:
    return vpColor::green;
  case vpFeatureState::CONTRAST:
    return vpColor::blue;
  case vpFeatureState::THRESHOLD:
    return vpColor::purple;
  case vpFeatureState::OUTLIER:
    break;
  }
  return vpColor::red;
}

void addLine(std::vector<std::vector<double>> &lines, const vpImagePoint &from, const vpImagePoint &to)
{
  lines.push_back({0., from.get_i(), from.get_j(), to.get_i(), to.get_j()});
}
} // namespace

std::vector<std::vector<double>> vpMbMultiCueTracker::getModelForDisplay(unsigned int width, unsigned int height,
                                                                         const vpHomogeneousMatrix &cMo,
                                                                         const vpCameraParameters &cam,
                                                                         bool displayFullModel)
{
  const vpModelLooks &looks = m_impl->engine().looks;
  looks.requireModel();
  m_impl->handOver();
  if (!m_impl->displayView) {
    m_impl->displayView = std::make_unique<vpModelView>(looks.view());
  }
  vpModelViewOptions options = looks.options;
  options.sampleStep = displayStep;
  options.border = 0.;
  options.allEdges = displayFullModel;
  for (vpFaceDetail &detail : options.details) {
    detail.tracked = true; // What takes no part is shown as well.
  }
  vpModelView &view = *m_impl->displayView;
  view.continueFrom(m_impl->engine().looks.view()); // Faces are shown as long as they are tracked.
  view.compute(cMo, cam, width, height, options, displayFullModel ? nullptr : m_impl->engine().looks.renderer());

  std::vector<std::vector<double>> lines;
  lines.reserve(view.points().size());
  for (const vpContour &contour : view.contours()) {
    for (int i = 0; i < contour.count; ++i) {
      // Each control point stands for half a step of its line on either side.
      const vpControlPoint &point = view.points()[static_cast<std::size_t>(contour.first + i)];
      const Eigen::Vector2d along = 0.5 * contour.step * Eigen::Vector2d(-point.normal.y(), point.normal.x());
      addLine(lines, vpDistortedPoint::of(point.pixel - along, cam), vpDistortedPoint::of(point.pixel + along, cam));
    }
  }
  return lines;
}

template <typename Pixel>
void vpMbMultiCueTracker::Impl::displayOn(const vpImage<Pixel> &I, const vpHomogeneousMatrix &cMo,
                                          const vpCameraParameters &cam, const vpColor &col, unsigned int thickness,
                                          bool displayFullModel)
{
  if (displayHypotheses) {
    displayHypothesesOn(I, cam, thickness);
  }
  if (m_engine.particles.isDisplayed) {
    displayParticlesOn(I, cam, thickness);
  }
  for (const std::vector<double> &line :
       m_tracker.getModelForDisplay(I.getWidth(), I.getHeight(), cMo, cam, displayFullModel)) {
    vpDisplay::displayLine(I, vpImagePoint(line[1], line[2]), vpImagePoint(line[3], line[4]), col, thickness);
  }
  if (m_tracker.displayFeatures) {
    for (const Feature &feature : featuresForDisplay()) {
      vpDisplay::displayCross(I, feature.place, 3, colorOf(feature.state), 1);
    }
  }
}

void vpMbMultiCueTracker::display(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo,
                                  const vpCameraParameters &cam, const vpColor &col, unsigned int thickness,
                                  bool displayFullModel)
{
  m_impl->displayOn(I, cMo, cam, col, thickness, displayFullModel);
}

void vpMbMultiCueTracker::display(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
                                  const vpCameraParameters &cam, const vpColor &col, unsigned int thickness,
                                  bool displayFullModel)
{
  m_impl->displayOn(I, cMo, cam, col, thickness, displayFullModel);
}

namespace {
// ViSP walks along whole lines, beyond the image too: for minutes where the object comes close to the camera's plane,
// and without an end where the camera is none.
bool isNearImage(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                 double reach)
{
  for (unsigned int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d oX(((corner & 1U) ? model.boxMax() : model.boxMin()).x(),
                             ((corner & 2U) ? model.boxMax() : model.boxMin()).y(),
                             ((corner & 4U) ? model.boxMax() : model.boxMin()).z());
    const Eigen::Vector3d cX = vpPoseExponential::toEigen(cMo) * oX;
    const double u = cam.get_px() * cX.x() / cX.z() + cam.get_u0();
    const double v = cam.get_py() * cX.y() / cX.z() + cam.get_v0();
    if (!(cX.z() > 0. && std::fabs(u) < reach && std::fabs(v) < reach)) {
      return false;
    }
  }
  return true;
}
} // namespace

double vpMbMultiCueTracker::computeCurrentProjectionError(const vpImage<unsigned char> &I,
                                                          const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
{
  m_impl->engine().looks.requireModel();
  const double reach = 10. * (I.getWidth() + I.getHeight()); // Pixels.
  if (!m_impl->hasMesh && isNearImage(m_impl->engine().looks.model(), cMo, cam, reach)) {
    m_projectionErrorCam = vpCameraParameters(0.5, 0.5, 0., 0.); // Another one: getLline() may have set theirs.
    return vpMbTracker::computeCurrentProjectionError(I, cMo, cam);
  }
  m_impl->handOver();
  vpModelView view(m_impl->engine().looks.view());
  view.compute(cMo, cam, I.getWidth(), I.getHeight(), m_impl->engine().looks.options,
               m_impl->engine().looks.renderer());
  return vpGradientAngle::mean(I, view, cam);
}

double vpMbMultiCueTracker::computeCurrentProjectionError(const vpImage<vpRGBa> &I_color,
                                                          const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
{
  vpImageConvert::convert(I_color, m_I);
  return computeCurrentProjectionError(m_I, cMo, cam);
}

END_VISP_NAMESPACE
