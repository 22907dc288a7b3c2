// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "tracker/vpDistortedPoint.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpDisplay.h>

BEGIN_VISP_NAMESPACE

namespace {
// Gray of the least likely potential edge; the most likely one is black.
const double lightest = 200.;

vpColor colorOf(std::size_t hypothesis)
{
  // Not green, blue, purple and red, which tell the states of features.
  static const vpColor colors[] = {vpColor::cyan, vpColor::yellow, vpColor::orange, vpColor::lightGreen,
                                   vpColor::lightRed};
  return colors[hypothesis % (sizeof(colors) / sizeof(colors[0]))];
}
} // namespace

void vpMbMultiCueTracker::setPoseHypothesisSettings(const vpPoseHypothesisSettings &settings)
{
  m_impl->hypotheses.setSettings(settings);
  if (!settings.enabled) {
    m_impl->hypotheses.clear();
  }
}

vpPoseHypothesisSettings vpMbMultiCueTracker::getPoseHypothesisSettings() const
{
  return m_impl->hypotheses.settings();
}

const std::vector<vpPoseHypothesis> &vpMbMultiCueTracker::getPoseHypotheses() const
{
  return m_impl->hypotheses.hypotheses();
}

unsigned int vpMbMultiCueTracker::getNbPoseMinimisations() const
{
  return m_impl->minimisations;
}

void vpMbMultiCueTracker::setDisplayHypotheses(bool flag)
{
  m_impl->displayHypotheses = flag;
}

void vpMbMultiCueTracker::proposePose()
{
  Impl &impl = *m_impl;
  impl.hypotheses.setEstimatedMotions(oJo);
  const std::vector<vpPoseHypothesis> &found = impl.hypotheses.find(impl.edges, *impl.view, m_cMo, impl.frames);
  impl.minimisations += impl.hypotheses.minimisations();
  if (!found.empty()) {
    m_cMo = found.front().cMo;
  }
}

template <typename Pixel>
void vpMbMultiCueTracker::displayHypothesesOn(const vpImage<Pixel> &I, const vpCameraParameters &cam,
                                              unsigned int thickness)
{
  const auto drawLine = [&](const Eigen::Vector2d &a, const Eigen::Vector2d &b, const vpColor &color) {
    vpDisplay::displayLine(I, vpDistortedPoint::of(a, cam), vpDistortedPoint::of(b, cam), color, thickness);
  };
  for (const vpPoseHypotheses::Line &line : m_impl->hypotheses.lines()) {
    const unsigned char gray = static_cast<unsigned char>(lightest * (1. - line.weight));
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      drawLine(line.points[i - 1], line.points[i], vpColor(gray, gray, gray));
    }
  }
  const std::vector<vpPoseHypothesis> &found = getPoseHypotheses();
  for (std::size_t h = found.size(); h > 0; --h) { // The best one on top.
    for (const std::vector<double> &line :
         getModelForDisplay(I.getWidth(), I.getHeight(), found[h - 1].cMo, cam, false)) {
      vpDisplay::displayLine(I, vpImagePoint(line[1], line[2]), vpImagePoint(line[3], line[4]), colorOf(h - 1),
                             thickness);
    }
  }
}

template void vpMbMultiCueTracker::displayHypothesesOn(const vpImage<unsigned char> &, const vpCameraParameters &,
                                                       unsigned int);
template void vpMbMultiCueTracker::displayHypothesesOn(const vpImage<vpRGBa> &, const vpCameraParameters &,
                                                       unsigned int);

END_VISP_NAMESPACE
