// SPDX-License-Identifier: GPL-2.0-or-later
#include "knowledge/vpObjectKnowledge.h"

#include "hypotheses/vpControlPointMotion.h"
#include "judge/vpJudgedPose.h"
#include "knowledge/vpSurfaceTrust.h"
#include "motion/vpTurnBetween.h"

#include <algorithm>
#include <cmath>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// What one cue counts at most and at least, as a share of the usual.
const double mostOfOne = 1.2;
const double leastOfOne = -0.5;
const double steadyReliability = 0.6; // Of colours, which below it may lead away from the object.
const double leastReliability = 0.2;  // Of a cue whose agreement comes and goes.
const double steadyVariance = 0.15 * 0.15;
const double shareOfStart = 0.8;
const double usualOfSurface = 0.6; // Of one that was seen once.
// Slower down (fallRate) than up: a wrong pose explains less, and must not become the usual one.
const double riseRate = 0.1;
const double countRate = 0.1;
const double nearerRate = 0.1; // Of the distance to the image's edges; fallRate where it grows.
const double unsteadinessRate = 0.05;
// Right poses have as much evidence of edges where the image shows the object at all.
const double leastUsualEvidence = 0.1;
// A depth buffer serves the surface at poses that move the control points by less than this, pixels.
const double nearDepth = 2.;
const double leastTurn = 0.25; // Radians, to tell its effect by.
// Share of the surface that has to be known to contradict a pose.
const double leastKnown = 0.3;
// Share of the usual agreement below which a surface may contradict a pose; and by how many squared deviations it has.
const double contradicting = 0.35;
const double contradictingDistance = 6.;
// Logarithm of odds for each share of the usual surface, beside those of what all cues explain together; the share that
// speaks neither for nor against a pose; and the variance of one that says half as much. A logistic regression over
// 5,900 poses that starts led to after losses (five objects, smooth motion and as of a hand, six seeds) gives 7.0 and
// 0.44, with one object left out 5.3 to 8.8. Of 302 frames in which a right pose was among the wrong ones, it came
// first in 290, and without in 279. With 7, recoveries are no better than with 5.
const double surfaceOddsPerShare = 5.;
const double evenSurface = 0.45;
const double tellingVariance = 0.2;
// Features of keyframes that may agree by chance, and so many that no other pose can be right.
const unsigned int fewestAgreeing = 8;
const unsigned int manyAgreeing = 24;
const double mostOfAll = 0.35; // Their weight, as a share of that of all other cues.
} // namespace

void vpObjectKnowledge::setModel(const vpTrackedModel &model, const std::vector<vpSurfaceSample> &samples)
{
  keyframes.setObject(model.centre(), model.diameter());
  surface.setSamples(samples);
}

void vpObjectKnowledge::forgetImages(double now)
{
  surface.reset();
  keyframes.reset();
  m_keyframeIsProvisional = false;
  past.clear();
  m_turnEffect.reset();
  m_turns = 0;
  m_period = 0;
  lastExplained = now;
  usual = vpAgreement();
  unsteadiness = vpAgreement();
}

double vpObjectKnowledge::countedShare(double value, double usual)
{
  return std::min(std::max(value / std::max(usual, leastUsual), leastOfOne), mostOfOne);
}

double vpObjectKnowledge::reliability(double variance)
{
  return std::max(steadyVariance / (steadyVariance + variance), leastReliability);
}

double vpObjectKnowledge::weightOf(const vpSurfaceMemory::Agreement &seen)
{
  return vpSurfaceTrust(seen.texture) * seen.known;
}

bool vpObjectKnowledge::hasUnsteadyColors() const
{
  return reliability(unsteadiness.cues[vpCueSet::COLOR]) < steadyReliability;
}

double vpObjectKnowledge::shareOfEvidence(double evidence) const
{
  const double known = std::max(usual.evidence, leastUsualEvidence) - evidenceByChance;
  return std::max(evidence - evidenceByChance, 0.) / known;
}

double vpObjectKnowledge::surfaceOdds(const vpSurfaceMemory::Agreement &seen, double variance) const
{
  const double telling = tellingVariance / (tellingVariance + variance);
  return surfaceOddsPerShare * telling * weightOf(seen) * (countedShare(seen.correlation, usual.surface) - evenSurface);
}

bool vpObjectKnowledge::isRefutedBy(const vpSurfaceMemory::Agreement &seen, double variance) const
{
  const double share = countedShare(seen.correlation, usual.surface);
  return weightOf(seen) > leastKnown && share < contradicting &&
         (1. - share) * (1. - share) > contradictingDistance * variance;
}

bool vpObjectKnowledge::tellsNothing(double variance)
{
  return (1. - contradicting) * (1. - contradicting) < contradictingDistance * variance;
}

double vpObjectKnowledge::turnSince(const vpHomogeneousMatrix &cMo, const vpObjectMotion &motion) const
{
  double least = vpTurnBetween(motion.trustedBefore ? motion.trustedBefore->cMo : motion.trusted.cMo, cMo);
  past.forEachOld([&](const std::shared_ptr<const Learnt> &learnt) {
    least = std::min(least, vpTurnBetween(learnt->trusted.cMo, cMo));
  });
  return least;
}

// Features that were seen in a trusted view and are seen again are hardly ever so by chance; but they may be those of
// what hides the object.
double vpObjectKnowledge::explainedBy(const vpCueShare &cues, const vpHomogeneousMatrix &cMo) const
{
  vpCueShare all = cues;
  if (mostAgreeing > fewestAgreeing) {
    const double weight =
        std::min(1., static_cast<double>(mostAgreeing - fewestAgreeing) / (manyAgreeing - fewestAgreeing));
    all.sum +=
        mostOfAll * weight * cues.cues * std::min(1., static_cast<double>(keyframes.agreeing(cMo)) / mostAgreeing);
    all.cues += mostOfAll * weight * cues.cues;
  }
  return all.cues > 0. ? std::min(all.sum / all.cues, cues.most) : 0.;
}

void vpObjectKnowledge::learnUsual(const vpAgreement &agreement, double fallRateNow)
{
  const auto learn = [fallRateNow](double value, double &usualValue, double &variance) {
    if (usualValue > 0.) {
      const double off = countedShare(value, usualValue) - 1.;
      variance += unsteadinessRate * (off * off - variance);
    }
    const double rate = usualValue > 0. ? (value > usualValue ? riseRate : fallRateNow) : 1.;
    usualValue += rate * (value - usualValue);
  };
  usual.edgeCount += countRate * (agreement.edgeCount - usual.edgeCount);
  const double clearer = agreement.evidence - usual.evidence;
  usual.evidence += (clearer > 0. ? riseRate : fallRateNow) * clearer;
  const double farther = agreement.mapDistance - usual.mapDistance;
  usual.mapDistance += (farther > 0. ? fallRateNow : nearerRate) * farther;
  for (std::size_t i = 0; i < usual.cues.of.size(); ++i) {
    learn(agreement.cues.of[i], usual.cues.of[i], unsteadiness.cues.of[i]);
  }
  if (agreement.surfaceWeight > leastTexture) {
    learn(agreement.surface, usual.surface, unsteadiness.surface);
  }
}

void vpObjectKnowledge::learnUsualOfStart(const vpAgreement &atStart, const vpCueSet &cues)
{
  if (cues.uses(vpCueSet::EDGE)) {
    usual.evidence = shareOfStart * (atStart.evidence - evidenceByChance) + evidenceByChance;
    usual.edgeCount = atStart.edgeCount;
    usual.mapDistance = atStart.mapDistance;
  }
  for (const vpCueSet::Used &used : cues.used()) {
    if (used.kind->vote != vpCueVote::POINTS) { // They have to be followed first.
      usual.cues[used.kind->type] = shareOfStart * atStart.cues[used.kind->type];
    }
  }
  if (hasTexture()) {
    usual.surface = usualOfSurface;
    unsteadiness.surface = steadyVariance; // It may look different in the next image.
  }
}

void vpObjectKnowledge::learnSurface(const vpHomogeneousMatrix &cMo, vpModelLooks &looks)
{
  const vpModelView &view = looks.view();
  const bool isConvex = looks.model().isConvex();
  if (isConvex || (view.depth() != nullptr &&
                   vpControlPointMotion::between(view, view.depthPose(), cMo, looks.camera()) < nearDepth)) {
    surface.learn(cMo, isConvex ? nullptr : view.depth());
  }
}

void vpObjectKnowledge::learnKeyframe(const vpCueFrame &image, const vpHomogeneousMatrix &cMo, vpModelLooks &looks,
                                      bool isStart)
{
  if (surface.texture() < leastTexture) {
    return;
  }
  const bool replaces = isStart || m_keyframeIsProvisional;
  if (m_keyframeIsProvisional) {
    keyframes.reset();
    m_keyframeIsProvisional = false;
  }
  keyframes.confirm(image, cMo);
  if (keyframes.wants(cMo)) {
    const vpRenderedView &depth = looks.renderDepth(cMo);
    if (replaces) {
      keyframes.learn(image, cMo, depth);
    } else {
      keyframes.propose(image, cMo, depth);
    }
  }
}

vpObjectKnowledge::Learnt vpObjectKnowledge::now(const vpCueSet &cues, const vpObjectMotion::Trusted &trusted) const
{
  Learnt learnt;
  for (const vpCueSet::Used &used : cues.used()) {
    learnt.cues[vpCueKinds::indexOf(used.kind->type)] = used.cue->reference();
  }
  learnt.surface = surface.reference();
  learnt.usual = usual;
  learnt.trusted = trusted;
  learnt.period = m_period;
  return learnt;
}

void vpObjectKnowledge::recall(const Learnt &learnt, vpCueSet &cues)
{
  for (const vpCueSet::Used &used : cues.used()) {
    const vpCueReference &reference = learnt.cues[vpCueKinds::indexOf(used.kind->type)];
    if (reference) {
      used.cue->recall(reference);
    }
  }
  surface.setReference(learnt.surface);
  usual = learnt.usual;
}

void vpObjectKnowledge::keep(double value, const vpCueSet &cues, const vpObjectMotion &motion)
{
  // A drift mostly explains less, or moves as the object did not.
  if (value < vpJudgedPose::enoughOdds) {
    return;
  }
  lastExplained = motion.time;
  if (past.count()) {
    learnTurnEffect(motion.trusted.cMo);
    past.keep(std::make_shared<const Learnt>(now(cues, motion.trusted)));
  }
}

// In a frame whose pose is trusted, from what was learnt at another orientation; one at a time, to save time.
void vpObjectKnowledge::learnTurnEffect(const vpHomogeneousMatrix &cMo)
{
  if (surface.texture() < leastTexture) {
    return;
  }
  std::vector<std::pair<double, const Learnt *>> turned;
  past.forEachOld([&](const std::shared_ptr<const Learnt> &learnt) {
    const double angle = vpTurnBetween(learnt->trusted.cMo, cMo);
    if (learnt->period == m_period && angle > leastTurn) { // Else one of the two poses may be wrong.
      turned.emplace_back(angle, learnt.get());
    }
  });
  if (turned.empty()) {
    return;
  }
  const auto &[angle, learnt] = turned[m_turns++ % turned.size()];
  const vpSurfaceMemory::Agreement seen = surface.agreement(cMo, learnt->surface);
  if (weightOf(seen) > leastTexture) {
    const double off = std::min(countedShare(seen.correlation, usual.surface) - 1., 0.);
    m_turnEffect.observe(angle, off * off - unsteadiness.surface);
  }
}

void vpObjectKnowledge::forgetPeriod()
{
  past.dropNewest([this](const std::shared_ptr<const Learnt> &learnt) { return learnt->period == m_period; });
}

END_VISP_NAMESPACE
