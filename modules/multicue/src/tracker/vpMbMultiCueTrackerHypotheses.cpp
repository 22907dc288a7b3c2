// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpControlPointMotion.h"
#include "tracker/vpDistortedPoint.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpDisplay.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// Gray of the least likely potential edge; the most likely one is black.
const double lightest = 200.;

// Hypotheses with less weight than this are not looked at again, nor more of them than these.
const double leastWeight = 0.02;
const std::size_t maxFinalists = 3;
// A match serves poses that move its control points by less than this.
const double nearMotion = 1.5; // Pixels.
const unsigned int maxRounds = 3;

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

// From the pose before; and where that leaves the image unexplained, once more with a longer reach, for there the
// object may have moved by more than the range. \return True where the last match serves m_cMo.
bool vpMbMultiCueTracker::proposePose(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  impl.hypotheses.setEstimatedMotions(oJo);
  const vpHomogeneousMatrix cMoStart = m_cMo;
  const bool matched = searchPoses(frame, impl.hypotheses.settings().minimisations);
  const double residue = impl.bestResidue();
  const double reach = impl.hypotheses.settings().reach;
  if (impl.explains(residue) || reach <= 1.) {
    return matched;
  }
  const vpHomogeneousMatrix cMoNear = m_cMo;
  const vpEdgeCueSettings settings = impl.edges.settings();
  vpEdgeCueSettings farther = settings;
  farther.range = std::min(reach * settings.range, vpEdgeCueSettings::maxRange);
  impl.edges.setSettings(farther);
  m_cMo = cMoStart;
  searchPoses(frame, impl.hypotheses.settings().minimisations);
  impl.edges.setSettings(settings);
  // Residues are compared at the usual range: with a longer one there is a candidate near to everything.
  bool matchedFar = searchPoses(frame, 1);
  if (impl.bestResidue() < residue) {
    return matchedFar;
  }
  m_cMo = cMoNear;
  return searchPoses(frame, 1);
}

// The poses that a match allows, and again from the best one while that has moved and the image is not explained yet.
// \return As proposePose().
bool vpMbMultiCueTracker::searchPoses(const vpCueFrame &frame, unsigned int most)
{
  Impl &impl = *m_impl;
  bool matched = false;
  unsigned int left = most;
  for (unsigned int round = 0; round < maxRounds && left > 0; ++round) {
    if (!matched) {
      match(frame, m_cMo);
    }
    const vpHomogeneousMatrix cMoBefore = m_cMo;
    impl.hypotheses.find(impl.edges, *impl.view, m_cMo, impl.draws++, std::min((most + 1) / 2, left));
    if (impl.hypotheses.hypotheses().empty()) {
      return true;
    }
    impl.minimisations += impl.hypotheses.minimisations();
    left -= impl.hypotheses.minimisations();
    matched = takeBestHypothesis(frame);
    const bool moved = vpControlPointMotion::between(*impl.view, cMoBefore, m_cMo, frame.camera()) >= nearMotion;
    if (!moved || impl.explains(impl.bestResidue())) {
      break;
    }
  }
  return matched;
}

// Poses that are about as likely are compared at a match of their own. \return As proposePose().
bool vpMbMultiCueTracker::takeBestHypothesis(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const std::vector<vpPoseHypothesis> &found = impl.hypotheses.hypotheses();
  std::size_t finalists = 1;
  while (finalists < std::min(found.size(), maxFinalists) && found[finalists].weight > leastWeight) {
    ++finalists;
  }
  if (finalists == 1) {
    m_cMo = found.front().cMo;
    return vpControlPointMotion::mean(*impl.view, m_cMo, frame.camera()) < nearMotion;
  }
  for (std::size_t i = finalists; i > 0; --i) { // The likeliest last: its match can stay.
    match(frame, found[i - 1].cMo);
    impl.hypotheses.refine(i - 1, impl.edges, impl.model->diameter());
  }
  const vpHomogeneousMatrix last = found.front().cMo;
  impl.hypotheses.rank();
  m_cMo = found.front().cMo;
  return std::equal(last.data, last.data + 16, m_cMo.data);
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
