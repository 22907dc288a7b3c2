// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpHypothesisColor.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpDisplay.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// More of them hide the image.
const std::size_t mostShown = 30;
// Gray of a particle without weight; the heaviest one is black.
const double lightest = 220.;
} // namespace

template <typename Pixel>
void vpMbMultiCueTracker::displayParticlesOn(const vpImage<Pixel> &I, const vpCameraParameters &cam,
                                             unsigned int thickness)
{
  const auto drawModel = [&](const vpHomogeneousMatrix &cMo, const vpColor &color, unsigned int width) {
    for (const std::vector<double> &line : getModelForDisplay(I.getWidth(), I.getHeight(), cMo, cam, false)) {
      vpDisplay::displayLine(I, vpImagePoint(line[1], line[2]), vpImagePoint(line[3], line[4]), color, width);
    }
  };
  std::vector<vpPoseParticle> particles = getParticles();
  std::stable_sort(particles.begin(), particles.end(),
                   [](const vpPoseParticle &a, const vpPoseParticle &b) { return a.weight > b.weight; });
  particles.resize(std::min(particles.size(), mostShown));
  for (std::size_t i = particles.size(); i > 0; --i) { // The heaviest on top.
    const double share = std::sqrt(particles[i - 1].weight / particles.front().weight);
    const unsigned char gray = static_cast<unsigned char>(lightest * (1. - share));
    drawModel(particles[i - 1].cMo, vpColor(gray, gray, gray), 1);
  }
  const std::vector<vpPoseMode> modes = getPoseModes();
  for (std::size_t i = modes.size(); i > 0; --i) {
    drawModel(modes[i - 1].cMo, vpHypothesisColor(i - 1), thickness + 1);
  }
}

template void vpMbMultiCueTracker::displayParticlesOn(const vpImage<unsigned char> &, const vpCameraParameters &,
                                                      unsigned int);
template void vpMbMultiCueTracker::displayParticlesOn(const vpImage<vpRGBa> &, const vpCameraParameters &,
                                                      unsigned int);

END_VISP_NAMESPACE
