// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/vpLearning.h"

BEGIN_VISP_NAMESPACE

namespace {
const double rightAtStart = 0.98; // Probability of a pose that the user gave.
// What hides a part of the object is not to be learnt as a keyframe: share of the usual, by all other cues.
const double whole = 0.7;
// Of a pose that is followed but not trusted: the filter takes its covariance times this.
const double doubtOfMotion = 10.;
const double mostOfMotion = 36.; // Squared distance from the expected pose, in deviations; beyond it, it jumped.
} // namespace

void vpLearning::forget()
{
  m_situation = vpSituation();
  m_situation.belief.start(rightAtStart);
  m_proof = vpFoundPoseProof();
  m_twins.end();
  m_cues.forget(m_looks);
  m_knowledge.forgetImages(m_motion.time);
  m_motion.forgetImages();
  m_score.forgetImages();
  m_particles.clear();
  m_minimiser.clear();
  m_edges.forgetImages();
  m_streams = vpRandomStreams();
  m_outcome = vpTrackingOutcome();
}

void vpLearning::trust(const vpHomogeneousMatrix &cMo, const vpPoseTangent &velocity)
{
  m_motion.trust(cMo, velocity);
  m_rough.depths.clear();
}

void vpLearning::learnStart(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  m_looks.setImage(frame.image);
  m_looks.compute(frame, cMo);
  if (!m_cues.isEdgesAlone()) {
    m_knowledge.surface.setFrame(frame.image);
    learnReferencesOfStart(frame, cMo);
    if (usesKeyframes()) {
      m_knowledge.learnKeyframe(frame.image, cMo, m_looks, true);
    }
    m_knowledge.expectKeyframe();
  }
  if (m_cues.uses(vpCueSet::EDGE)) {
    m_cues.edges().match(frame.image, m_looks.view());
  }
  const bool looksAtMap = m_cues.isEdgesAlone() && m_settings.searches;
  if (looksAtMap) {
    m_score.setFrame(frame);
  }
  m_knowledge.learnUsualOfStart(m_judge.agreementAtStart(cMo, looksAtMap), m_cues);
}

void vpLearning::learnReferencesOfStart(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  std::vector<vpCueSet::Used> learning;
  for (const vpCueSet::Used &used : m_cues.used()) {
    if (used.cue->matchStart(frame.image, m_looks.view())) {
      learning.push_back(used);
    }
  }
  m_minimiser.takeAsTheyAre(learning, cMo);
  learnReferences(cMo);
}

void vpLearning::learnReferences(const vpHomogeneousMatrix &cMo)
{
  for (const vpCueSet::Used &used : m_cues.used()) {
    const vpCueFusion::Part *part = m_minimiser.fusion().find(used.kind->type);
    if (part != nullptr) {
      used.cue->learn(cMo, part->weights, m_looks);
    } else {
      used.cue->learnRefused(cMo, m_looks.camera());
    }
  }
  if (!m_cues.isEdgesAlone()) {
    m_knowledge.learnSurface(cMo, m_looks);
  }
}

void vpLearning::learn(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, const vpVerdict &verdict,
                       double value)
{
  ++m_situation.trustedFrames;
  learnReferences(cMo);
  m_edges.learnResidue();
  if (m_outcome.isTracking()) {
    m_knowledge.learnUsual(verdict.agreement, m_proof.fallRateOfUsual(m_situation.trustedFrames));
  }
  if (usesKeyframes() && verdict.share.sum > whole * verdict.share.cues) {
    m_knowledge.learnKeyframe(frame.image, cMo, m_looks, false);
  }
  m_motion.learnSurprise(cMo, m_looks.model());
  updateMotion(cMo, 1.);
  trust(cMo, m_motion.kalman.velocity());
  if (m_settings.searches) {
    m_knowledge.keep(value, m_cues, m_motion);
  }
  m_motion.updateInertia(cMo);
}

void vpLearning::followDoubtful(const vpHomogeneousMatrix &cMo)
{
  if (m_motion.surpriseAt(cMo, m_looks.model()) < mostOfMotion) {
    updateMotion(cMo, doubtOfMotion);
  } else if (m_motion.predicts) {
    m_motion.forget();
  }
}

// True where the Kalman filter has to follow the object.
bool vpLearning::usesVelocity() const
{
  const vpParticleSettings &particles = m_particles.settings();
  return m_motion.predicts || m_settings.searches ||
         (particles.enabled && particles.motion == vpParticleSettings::VELOCITY);
}

void vpLearning::updateMotion(const vpHomogeneousMatrix &cMo, double doubt)
{
  if (usesVelocity()) {
    const vpPoseMatrix6 covariance = m_covariance.ofMotion();
    m_motion.update(cMo, holdsTurns() ? m_symmetries.settled(covariance, cMo) : covariance, doubt,
                    m_looks.model().diameter());
  }
}

void vpLearning::updateCovariance(const vpHomogeneousMatrix &cMo)
{
  if (m_settings.computesCovariance || usesVelocity()) {
    m_covariance.update(m_minimiser.fusion(), cMo, m_looks, m_minimiser.chosenMotions());
  }
}

END_VISP_NAMESPACE
