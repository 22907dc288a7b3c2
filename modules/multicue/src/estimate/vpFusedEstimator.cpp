// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpFusedEstimator.h"

#include "frame/vpStopwatch.h"
#include "hypotheses/vpControlPointMotion.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// When the pose moved the control points by more than this, the match before is not one for the new pose.
const double rematchMotion = 1.5; // Pixels.
const unsigned int maxRounds = 3;
// A pose that is farther than this from its origin has diverged, in diameters.
const double maxMotion = 1.;
// A view serves poses that move its control points by less than this, pixels; coarse levels: times their scale.
const double nearMotion = 0.5;
// How far from where it is expected the object may well be: in diameters, and radians.
const double leastMotion = 0.04;
const double mostMotion = 0.15;
// In standard deviations of how far it was from there in the frames before.
const double motionFactor = 2.;
// Fewer points found tell no pose by themselves.
const std::size_t fewestPoints = 12;
// Share of the points looked for that have to agree on a pose.
const double leastAgreeing = 0.5;
// Points that move the object by more than this have to agree with the colours, pixels.
const double contradiction = 3.;
// A level of the colours that is fine enough to tell poses apart, and reaches far enough to be wrong about both.
const unsigned int evidenceLevel = 1;
// Share of the usual evidence from which on the contour is within reach of that level.
const double nearContour = 0.75;
} // namespace

vpEstimate vpFusedEstimator::from(const vpFrameContext &frame, const vpStart &start)
{
  vpStart finer = start;
  finer.origin = start.from();
  bool usesPoints = false;
  if (start.way != vpStart::AS_VIEWED) {
    m_looks.update(frame, start.cMo, 0.);
  }
  if (start.way == vpStart::COARSE_TO_FINE && m_cues.uses(vpCueSet::POINT)) {
    usesPoints = byPoints(frame, start, finer.cMo);
  }
  if (start.way <= vpStart::BY_COLORS && m_cues.uses(vpCueSet::COLOR)) {
    finer.cMo = byCoarseColors(frame, finer, usesPoints);
  }
  return refine(frame, finer, usesPoints);
}

// As wide as the object was off the expected poses lately. Around the predicted one, what the image does not show, as
// of an object that is nearly outside, goes on as it moved; else it may drift from one minimisation to the next.
vpPosePrior vpFusedEstimator::priorOf(const vpStart &start, const vpHomogeneousMatrix &cMo) const
{
  const auto width = [](double variance) {
    return std::min(std::max(motionFactor * std::sqrt(variance), leastMotion), mostMotion);
  };
  const std::array<double, 2> &surprise = m_motion.surprise();
  vpPoseTangent deviations;
  deviations.head<3>().setConstant(width(surprise[0]) * m_looks.model().diameter());
  deviations.tail<3>().setConstant(width(surprise[1]));
  vpPosePrior prior;
  prior.set(start.holdsPrediction ? m_motion.expected() : cMo, m_looks.centreFrame(), deviations);
  return prior;
}

bool vpFusedEstimator::minimise(const vpFrameContext &frame, int cues, const vpStart &start, vpHomogeneousMatrix &cMo)
{
  const vpPosePrior prior = priorOf(start, cMo);
  return m_minimiser.minimise(frame, {cues, &prior}, m_cues, m_symmetries, m_looks.model().diameter(), cMo);
}

vpEstimate vpFusedEstimator::refine(const vpFrameContext &frame, const vpStart &start, bool usesPoints)
{
  vpEstimate result{start.cMo, false, usesPoints};
  const int cues = usesPoints ? m_cues.type() : m_cues.type() & ~vpCueSet::POINT;
  for (unsigned int round = 0; round < maxRounds; ++round) {
    const vpModelView &view = m_looks.update(frame, result.cMo, nearMotion);
    bool isFinest = true;
    {
      const vpStopwatch stage(frame.timings.match);
      for (const vpCueSet::Used &used : m_cues.used()) {
        used.cue->matchFine(frame.image, view, round);
        isFinest = isFinest && used.cue->isFinest(round);
      }
    }
    // A pose that is far from the one that it started from has diverged.
    if (!minimise(frame, cues, start, result.cMo) || !std::isfinite(result.cMo[0][0]) ||
        !((start.from().getTranslationVector() - result.cMo.getTranslationVector()).frobeniusNorm() <
          maxMotion * m_looks.model().diameter())) {
      return result;
    }
    if (isFinest && vpControlPointMotion::mean(view, result.cMo, frame.image.camera()) < rematchMotion) {
      break;
    }
  }
  result.isFound = true;
  return result;
}

// Few points, or many that disagree, are those of something else, or of a pose too far away to find them.
bool vpFusedEstimator::pointsAgree() const
{
  const std::vector<double> &weights = m_minimiser.fusion()[0].weights;
  const auto kept = static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0.; }));
  const std::size_t searched = m_cues.pointPart().points()->matches().size();
  return kept >= 2 * fewestPoints && static_cast<double>(kept) >= 2. * leastAgreeing * static_cast<double>(searched);
}

// How well the colours agree with a pose, see vpColorCue::evidence().
double vpFusedEstimator::colorEvidence(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  const vpModelView &view = m_looks.update(frame, cMo, nearMotion);
  const vpStopwatch stage(frame.timings.match);
  m_cues.colorPart().matchLevel(frame.image, view, evidenceLevel);
  return m_cues.color().evidence();
}

// Points reach far. Those of what passes in front of the object agree on a pose, too, but the colours do not.
// \return False where they contradict the colours.
bool vpFusedEstimator::byPoints(const vpFrameContext &frame, const vpStart &start, vpHomogeneousMatrix &cMo)
{
  {
    const vpStopwatch stage(frame.timings.match);
    m_cues.pointPart().cue().match(frame.image, m_looks.view());
  }
  vpHomogeneousMatrix found = cMo;
  if (!minimise(frame, vpCueSet::POINT, start, found) || !pointsAgree()) {
    return true;
  }
  const bool hasCoarse = m_cues.uses(vpCueSet::COLOR) && evidenceLevel < m_cues.colorPart().coarseLevels();
  if (hasCoarse && !(vpControlPointMotion::mean(m_looks.view(), found, frame.image.camera()) < contradiction)) {
    const double before = colorEvidence(frame, cMo);
    if (colorEvidence(frame, found) < before) {
      return false;
    }
  }
  cMo = found;
  return true;
}

// Coarse to fine; the levels that reach far are left out where the contour is near already.
vpHomogeneousMatrix vpFusedEstimator::byCoarseColors(const vpFrameContext &frame, const vpStart &start, bool usesPoints)
{
  vpHomogeneousMatrix cMo = start.cMo;
  vpTrackedColors &colors = m_cues.colorPart();
  const unsigned int levels = colors.coarseLevels();
  const double usual = std::max(m_knowledge.usual.cues[vpCueSet::COLOR], vpObjectKnowledge::leastUsual);
  unsigned int level = 0;
  if (levels > evidenceLevel && colorEvidence(frame, cMo) >= nearContour * usual) {
    level = evidenceLevel;
  }
  for (bool again = level == 0; level < levels;) {
    const vpModelView &view = m_looks.update(frame, cMo, nearMotion * colors.cue().settings().scales[level]);
    {
      const vpStopwatch stage(frame.timings.match);
      colors.matchLevel(frame.image, view, level);
    }
    vpHomogeneousMatrix found = cMo;
    if (minimise(frame, withPoints(vpCueSet::COLOR, usesPoints), start, found)) {
      cMo = found;
    }
    level += again ? 0 : 1; // The coarsest one twice: its lines reach farther when they lie better.
    again = false;
  }
  return cMo;
}

END_VISP_NAMESPACE
