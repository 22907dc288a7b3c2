// SPDX-License-Identifier: GPL-2.0-or-later
#include "facade/vpTrackerImpl.h"

#include "estimate/vpUnobservedMotions.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
using Reason = vpMbTrackingResult::Reason;

const vpCueKind &requireKind(int cue)
{
  const vpCueKind *kind = vpCueKinds::find(cue);
  if (kind == nullptr) {
    throw vpException(vpException::badValue, "%d is no cue: use one of vpMbMultiCueTracker's %s", cue,
                      vpCueKinds::listText().c_str());
  }
  return *kind;
}
} // namespace

vpMbTrackingResult::Cue vpMbMultiCueTracker::Impl::resultOf(int cue) const
{
  const vpTrackingOutcome::Support &support = m_engine.outcome.of[vpCueKinds::indexOf(cue)];
  const vpCueKind &kind = *vpCueKinds::find(cue);
  vpMbTrackingResult::Cue result;
  result.type = cue;
  result.name = kind.name;
  result.expected = support.expected;
  result.good = support.good;
  // Beside other cues points are not asked.
  const bool isAsked = kind.vote != vpCueVote::POINTS || m_engine.cues.type() == cue;
  result.agreement = isAsked ? m_engine.agreement().cues[cue] : std::numeric_limits<double>::quiet_NaN();
  if (support.good == 0 && result.agreement > 0.) {
    result.agreement = 0.; // What is remembered is of a frame before.
  }
  result.reason = m_tracker.getCueReason(cue);
  return result;
}

std::string vpMbMultiCueTracker::Impl::reasonText() const
{
  if (m_engine.looks.width() == 0) {
    return "no initial pose was given";
  }
  const std::string &said = m_engine.rough.detectorText;
  const std::string detector = said.empty() ? "" : "; " + said;
  const bool coasts = m_engine.outcome.reason == Reason::COASTING;
  const std::string &text = m_engine.outcome.text; // Empty where all was forgotten and nothing came after.
  const std::string &failed = m_engine.outcome.failure;
  return (text.empty() ? "no image was tracked yet" : text) + (coasts ? "; the pose is the predicted one" : "") +
         detector + (failed.empty() ? "" : "; " + failed);
}

vpMbTrackingResult vpMbMultiCueTracker::getTrackingResult() const
{
  const vpMultiCueEngine &engine = m_impl->engine();
  vpMbTrackingResult result;
  result.cMo = m_cMo;
  if (computeCovariance) {
    result.covariance = getCovarianceMatrix();
  }
  result.state = engine.outcome.state;
  result.score = engine.score();
  result.reason = engine.outcome.reason;
  result.text = m_impl->reasonText();
  for (const vpCueSet::Used &used : engine.cues.used()) {
    result.cues.push_back(m_impl->resultOf(used.kind->type));
  }
  if (engine.outcome.isJudged) {
    result.unobserved = vpUnobservedMotions(engine.looks.model(), engine.symmetries).find(engine.minimiser.fusion());
  }
  result.hypotheses = getPoseHypotheses();
  result.timings = engine.timings;
  result.putOff = engine.deadline.putOff();
  return result;
}

vpTrackingState vpMbMultiCueTracker::getTrackingState() const
{
  return m_impl->engine().outcome.state;
}

double vpMbMultiCueTracker::getSupport() const
{
  return m_impl->engine().outcome.support();
}

const vpTrackingTimings &vpMbMultiCueTracker::getTimings() const
{
  return m_impl->engine().timings;
}

const std::vector<vpPoseHypothesis> &vpMbMultiCueTracker::getPoseHypotheses() const
{
  return m_impl->engine().edges.found();
}

unsigned int vpMbMultiCueTracker::getNbPoseMinimisations() const
{
  return m_impl->engine().edges.minimisations();
}

void vpMbMultiCueTracker::setDisplayHypotheses(bool flag)
{
  m_impl->displayHypotheses = flag;
}

vpMatrix vpMbMultiCueTracker::getCovarianceMatrix(int cue) const
{
  const vpCueKind &kind = requireKind(cue);
  if (!computeCovariance) {
    throw vpException(vpException::notInitialized,
                      "No covariance was computed: call setCovarianceComputation(true) before track()");
  }
  const std::string reason = getCueReason(cue);
  if (!reason.empty()) {
    throw vpException(vpException::notInitialized, kind.constant + " has no covariance: " + reason);
  }
  const vpCueFusion &fusion = m_impl->engine().minimiser.fusion();
  std::size_t part = 0;
  while (fusion[part].type != cue) { // It is there: there is no reason against it.
    ++part;
  }
  return m_impl->engine().covariance.ofParameters(m_cMo, part);
}

std::string vpMbMultiCueTracker::getCueReason(int cue) const
{
  const vpCueKind &kind = requireKind(cue);
  const vpMultiCueEngine &engine = m_impl->engine();
  if (!engine.cues.uses(cue)) {
    return "it is not among the cues chosen by setTrackerType()";
  }
  if (!engine.outcome.isJudged) {
    return "no image was tracked yet";
  }
  const vpCueFusion::Part *part = engine.minimiser.fusion().find(cue);
  if (part == nullptr) {
    const bool isRefused = kind.vote == vpCueVote::POINTS && !engine.outcome.usesPoints;
    return isRefused ? "the points contradict the other cues" : "no pose was estimated";
  }
  if (part->block.rows.empty()) {
    return engine.cues.find(cue).cue->missing();
  }
  const bool isRefused = std::all_of(part->weights.begin(), part->weights.end(), [](double w) { return w <= 0.; });
  return isRefused ? "the robust estimation refused all of its " + std::to_string(part->block.rows.size()) + " rows"
                   : "";
}

unsigned int vpMbMultiCueTracker::Impl::nbFeatures(int type) const
{
  const vpCueFusion::Part *part = m_engine.minimiser.fusion().find(type);
  return part == nullptr ? 0 : static_cast<unsigned int>(part->block.rows.size());
}

unsigned int vpMbMultiCueTracker::getNbFeaturesEdge() const
{
  return m_impl->nbFeatures(EDGE_TRACKER);
}

unsigned int vpMbMultiCueTracker::getNbFeaturesKlt() const
{
  return m_impl->nbFeatures(KLT_TRACKER);
}

unsigned int vpMbMultiCueTracker::getNbFeaturesColor() const
{
  return m_impl->nbFeatures(COLOR_TRACKER);
}

unsigned int vpMbMultiCueTracker::getNbPoints(unsigned int level) const
{
  requireLevel(level);
  return m_impl->engine().outcome.of[vpCueKinds::indexOf(EDGE_TRACKER)].good;
}

std::vector<vpPoseParticle> vpMbMultiCueTracker::getParticles() const
{
  const vpPoseParticleFilter &filter = m_impl->engine().particles.filter();
  std::vector<vpPoseParticle> particles(filter.size());
  if (particles.empty()) {
    return particles;
  }
  const vpHomogeneousMatrix bMo = m_impl->engine().looks.centreFrame().inverse();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles[i] = {filter.pose(i) * bMo, filter.weights()[i]};
  }
  return particles;
}

std::vector<vpPoseMode> vpMbMultiCueTracker::getPoseModes() const
{
  std::vector<vpPoseMode> modes = m_impl->engine().particles.modes();
  if (modes.empty()) {
    return modes;
  }
  const vpHomogeneousMatrix oMb = m_impl->engine().looks.centreFrame();
  const vpPoseMatrix6 oVb = vpPoseExponential::adjoint(oMb);
  for (vpPoseMode &mode : modes) {
    mode.cMo = mode.cMo * oMb.inverse();
    mode.covariance = oVb * mode.covariance * oVb.transpose();
  }
  return modes;
}

vpHomogeneousMatrix vpMbMultiCueTracker::getParticleMean() const
{
  const vpTrackerParticles &particles = m_impl->engine().particles;
  return particles.isStarted() ? particles.mean() * m_impl->engine().looks.centreFrame().inverse() : m_cMo;
}

void vpMbMultiCueTracker::setDisplayParticles(bool flag)
{
  m_impl->engine().particles.isDisplayed = flag;
}

END_VISP_NAMESPACE
