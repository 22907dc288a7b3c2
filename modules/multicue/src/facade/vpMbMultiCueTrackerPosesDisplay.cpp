// SPDX-License-Identifier: GPL-2.0-or-later
#include "facade/vpDistortedPoint.h"
#include "facade/vpHypothesisColor.h"
#include "facade/vpTrackerImpl.h"

#include <visp3/core/vpDisplay.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// More of them hide the image.
const std::size_t mostShown = 30;
// Gray of a particle without weight; the heaviest one is black.
const double lightest = 220.;
// Gray of the least likely potential edge; the most likely one is black.
const double lightestEdge = 200.;
} // namespace

template <typename Pixel>
void vpMbMultiCueTracker::Impl::displayParticlesOn(const vpImage<Pixel> &I, const vpCameraParameters &cam,
                                                   unsigned int thickness)
{
  const auto drawModel = [&](const vpHomogeneousMatrix &cMo, const vpColor &color, unsigned int width) {
    for (const std::vector<double> &line : m_tracker.getModelForDisplay(I.getWidth(), I.getHeight(), cMo, cam, false)) {
      vpDisplay::displayLine(I, vpImagePoint(line[1], line[2]), vpImagePoint(line[3], line[4]), color, width);
    }
  };
  std::vector<vpPoseParticle> particles = m_tracker.getParticles();
  std::stable_sort(particles.begin(), particles.end(),
                   [](const vpPoseParticle &a, const vpPoseParticle &b) { return a.weight > b.weight; });
  particles.resize(std::min(particles.size(), mostShown));
  for (std::size_t i = particles.size(); i > 0; --i) { // The heaviest on top.
    const double share = std::sqrt(particles[i - 1].weight / particles.front().weight);
    const unsigned char gray = static_cast<unsigned char>(lightest * (1. - share));
    drawModel(particles[i - 1].cMo, vpColor(gray, gray, gray), 1);
  }
  const std::vector<vpPoseMode> modes = m_tracker.getPoseModes();
  for (std::size_t i = modes.size(); i > 0; --i) {
    drawModel(modes[i - 1].cMo, vpHypothesisColor(i - 1), thickness + 1);
  }
}

template void vpMbMultiCueTracker::Impl::displayParticlesOn(const vpImage<unsigned char> &, const vpCameraParameters &,
                                                            unsigned int);
template void vpMbMultiCueTracker::Impl::displayParticlesOn(const vpImage<vpRGBa> &, const vpCameraParameters &,
                                                            unsigned int);

template <typename Pixel>
void vpMbMultiCueTracker::Impl::displayHypothesesOn(const vpImage<Pixel> &I, const vpCameraParameters &cam,
                                                    unsigned int thickness)
{
  const auto drawLine = [&](const Eigen::Vector2d &a, const Eigen::Vector2d &b, const vpColor &color) {
    vpDisplay::displayLine(I, vpDistortedPoint::of(a, cam), vpDistortedPoint::of(b, cam), color, thickness);
  };
  for (const vpPoseHypotheses::Line &line : m_engine.edges.hypotheses().lines()) {
    const unsigned char gray = static_cast<unsigned char>(lightestEdge * (1. - line.weight));
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      drawLine(line.points[i - 1], line.points[i], vpColor(gray, gray, gray));
    }
  }
  const std::vector<vpPoseHypothesis> &found = m_engine.edges.found();
  for (std::size_t h = found.size(); h > 0; --h) { // The best one on top.
    for (const std::vector<double> &line :
         m_tracker.getModelForDisplay(I.getWidth(), I.getHeight(), found[h - 1].cMo, cam, false)) {
      vpDisplay::displayLine(I, vpImagePoint(line[1], line[2]), vpImagePoint(line[3], line[4]),
                             vpHypothesisColor(h - 1), thickness);
    }
  }
}

template void vpMbMultiCueTracker::Impl::displayHypothesesOn(const vpImage<unsigned char> &, const vpCameraParameters &,
                                                             unsigned int);
template void vpMbMultiCueTracker::Impl::displayHypothesesOn(const vpImage<vpRGBa> &, const vpCameraParameters &,
                                                             unsigned int);

END_VISP_NAMESPACE
