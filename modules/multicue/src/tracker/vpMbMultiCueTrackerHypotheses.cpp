// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpControlPointMotion.h"
#include "facade/vpDistortedPoint.h"
#include "facade/vpHypothesisColor.h"
#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpDisplay.h>

#include <algorithm>
#include <cmath>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// Gray of the least likely potential edge; the most likely one is black.
const double lightest = 200.;

// Hypotheses with less weight than this are not looked at again, nor more of them than these.
const double leastWeight = 0.02;
const std::size_t maxFinalists = 3;
// A match serves poses that move its control points by less than this.
const double nearMotion = 1.5; // Pixels.
// Matches for a pose that a longer reach led to.
const unsigned int maxRefinements = 2;
} // namespace

void vpMbMultiCueTracker::setPoseHypothesisSettings(const vpPoseHypothesisSettings &settings)
{
  m_impl->hypotheses.setSettings(settings);
  m_impl->otherHypotheses.setSettings(settings);
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

// From the pose before; and where that leaves the image unexplained, with a longer reach, for there the object may have
// moved by more than the range. \return True where the last match serves m_cMo.
bool vpMbMultiCueTracker::proposePose(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const vpPoseHypothesisSettings &settings = impl.hypotheses.settings();
  const bool mayReach = settings.reach > 1.;
  impl.restrictHypotheses(oJo);
  const vpHomogeneousMatrix cMoStart = m_cMo;
  match(frame, m_cMo);
  // Several poses that explain the image have to be compared. Where the likeliest one does not, the next ones of the
  // same match seldom do, and what they cost is better spent on a longer reach.
  const unsigned int limit = mayReach ? std::min((settings.minimisations + 1) / 2, impl.minimisationsLeft()) : 0;
  const double decisive = mayReach ? impl.explainedResidue() : HUGE_VAL;
  const bool matched = !findPoses(limit, decisive) || takeBestHypothesis(frame);
  return !mayReach || impl.explains(impl.bestResidue()) ? matched : reachFarther(frame, cMoStart);
}

// The poses that the last match allows. \return False where there is none.
bool vpMbMultiCueTracker::findPoses(unsigned int limit, double decisive)
{
  Impl &impl = *m_impl;
  const vpStopwatch stage(impl.timings.pose);
  impl.hypotheses.find(impl.edges, *impl.view, m_cMo, impl.draws++, limit, decisive);
  impl.minimisations += impl.hypotheses.minimisations();
  return !impl.hypotheses.hypotheses().empty();
}

// The better one of m_cMo, which the search at the usual range led to, and of what a longer one finds.
// \return As proposePose().
bool vpMbMultiCueTracker::reachFarther(const vpCueFrame &frame, const vpHomogeneousMatrix &cMoStart)
{
  Impl &impl = *m_impl;
  const double residue = impl.bestResidue();
  const vpHomogeneousMatrix cMoNear = m_cMo;
  std::swap(impl.hypotheses, impl.otherHypotheses);
  impl.restrictHypotheses(oJo);
  m_cMo = cMoStart;
  // Residues are compared at the usual range: with a longer one there is a candidate near to everything.
  bool serves = false;
  if (searchFarther(frame)) {
    serves = refineHypothesis(frame, 0, maxRefinements);
    m_cMo = impl.hypotheses.hypotheses().front().cMo;
    if (impl.bestResidue() < residue) {
      return serves;
    }
  }
  std::swap(impl.hypotheses, impl.otherHypotheses);
  m_cMo = cMoNear;
  return false;
}

// One pose after the other, each from a match at the one before. \return False where the last match allows none.
bool vpMbMultiCueTracker::searchFarther(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  const double reach = impl.hypotheses.settings().reach;
  const vpEdgeCueSettings settings = impl.edges.settings();
  vpEdgeCueSettings farther = settings;
  farther.range = std::min(reach * settings.range, vpEdgeCueSettings::maxRange);
  // A longer line meets more that is not the edge: only what is most like it.
  farther.candidates = std::max(static_cast<unsigned int>(settings.candidates / reach), 1U);
  impl.edges.setSettings(farther);
  bool found = false;
  bool moved = true;
  for (unsigned int left = impl.minimisationsLeft(); moved && left > 0; --left) {
    match(frame, m_cMo);
    found = findPoses(1, HUGE_VAL);
    const vpHomogeneousMatrix cMoBefore = m_cMo;
    m_cMo = found ? impl.hypotheses.hypotheses().front().cMo : m_cMo;
    moved = vpControlPointMotion::between(*impl.view, cMoBefore, m_cMo, frame.camera()) >= nearMotion;
  }
  impl.edges.setSettings(settings);
  return found;
}

// Matches a hypothesis at its own pose and minimises it there, again while it moves. \return As proposePose().
bool vpMbMultiCueTracker::refineHypothesis(const vpCueFrame &frame, std::size_t index, unsigned int most)
{
  Impl &impl = *m_impl;
  const vpHomogeneousMatrix &cMo = impl.hypotheses.hypotheses()[index].cMo;
  bool serves = false;
  for (unsigned int i = 0; i < most && !serves; ++i) {
    matchNear(frame, cMo);
    const vpStopwatch stage(impl.timings.pose);
    impl.hypotheses.refine(index, impl.edges, impl.model->diameter());
    serves = vpControlPointMotion::mean(*impl.view, cMo, frame.camera()) < nearMotion;
  }
  return serves;
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
  bool serves = false;
  for (std::size_t i = finalists; i > 0; --i) { // The likeliest last: its match can stay.
    serves = refineHypothesis(frame, i - 1, 1);
  }
  const vpHomogeneousMatrix last = found.front().cMo;
  impl.hypotheses.rank();
  m_cMo = found.front().cMo;
  return serves && std::equal(last.data, last.data + 16, m_cMo.data);
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
      vpDisplay::displayLine(I, vpImagePoint(line[1], line[2]), vpImagePoint(line[3], line[4]),
                             vpHypothesisColor(h - 1), thickness);
    }
  }
}

template void vpMbMultiCueTracker::displayHypothesesOn(const vpImage<unsigned char> &, const vpCameraParameters &,
                                                       unsigned int);
template void vpMbMultiCueTracker::displayHypothesesOn(const vpImage<vpRGBa> &, const vpCameraParameters &,
                                                       unsigned int);

END_VISP_NAMESPACE
