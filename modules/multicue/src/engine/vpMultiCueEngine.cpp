// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/vpMultiCueEngine.h"

#include "motion/vpPoseCheck.h"

BEGIN_VISP_NAMESPACE

namespace {
// Places on the surface whose colours are remembered.
const std::size_t surfacePlaces = 500;
} // namespace

vpMultiCueEngine::vpMultiCueEngine(vpServoing &servoing)
    : minimiser(servoing), edges(looks, cues, minimiser, symmetries),
      m_alike(looks, symmetries, motion, situation, particles),
      m_whereabouts(looks, motion, situation, m_proof, m_halfTurns, rough),
      m_score(looks, cues, m_knowledge, situation), m_judge(looks, cues, motion, m_knowledge, m_score, situation),
      m_fused(looks, cues, minimiser, motion, m_knowledge, symmetries),
      m_learning(settings, looks, cues, minimiser, edges, covariance, symmetries, motion, m_knowledge, m_score, m_judge,
                 situation, m_proof, m_twins, particles, rough, m_streams, outcome),
      m_attempts(m_fused, m_judge, looks, cues, motion, m_knowledge, m_score, m_whereabouts, m_alike, situation),
      m_capture(looks, cues, edges), m_hints(looks, m_score, m_capture, rough),
      m_starter(looks, cues, m_fused, edges, motion, m_score, m_alike, m_learning, rough, outcome),
      m_keyframes(looks, motion, m_knowledge, m_attempts),
      m_near(looks, motion, m_score, symmetries, particles, m_attempts),
      m_everywhere(looks, cues, motion, m_score, symmetries, m_halfTurns, m_whereabouts, rough, situation, m_attempts),
      m_plan(settings, looks, cues, edges, motion, m_proof, m_halfTurns, m_alike, situation, outcome, m_hints, rough,
             m_keyframes, m_near, m_everywhere, m_attempts),
      m_twinComparison(looks, cues, m_fused, edges, m_score, m_knowledge, m_alike, symmetries, m_halfTurns, m_proof,
                       m_twins),
      m_watch(looks, cues, motion, m_knowledge, m_score, m_judge, m_whereabouts, m_alike, m_halfTurns, situation,
              m_proof, m_twins, outcome),
      m_rivals(settings, looks, cues, minimiser, edges, m_score, symmetries, m_alike, particles, outcome),
      m_explorer(looks, edges, motion, m_score, rough, m_rivals, particles, outcome),
      m_follower(settings, looks, cues, minimiser, edges, motion, m_knowledge, m_score, m_judge, situation, m_capture,
                 m_hints, m_starter, outcome)
{
  looks.options.textureEdges = true;
}

void vpMultiCueEngine::setModel(vpTrackedModel &&model)
{
  looks.setModel(std::make_shared<const vpTrackedModel>(std::move(model)));
  symmetries.setModel(looks.model());
  m_score.setModel();
  rough.search.setModel(looks.pointer());
  rough.imageSearch.setModel(looks.pointer());
  const std::vector<vpSurfaceSample> samples = vpSampleSurface(looks.model(), surfacePlaces);
  m_knowledge.setModel(looks.model(), samples);
  m_halfTurns.setModel(looks.model(), samples);
  forgetImages();
}

void vpMultiCueEngine::forgetImages()
{
  m_captured.reset();
  deadline.startFrame();
  m_learning.forget();
  m_follower.forgetImages();
}

vpFrameContext vpMultiCueEngine::frameOf(const vpCueFrame &image)
{
  return {image, timings, deadline, m_streams};
}

vpFrameContext vpMultiCueEngine::startOf(const vpCueFrame &image)
{
  return {image, timings, m_noDeadline, m_streams};
}

void vpMultiCueEngine::start(unsigned int width, unsigned int height, const vpHomogeneousMatrix &cMo)
{
  m_learning.trust(cMo);
  looks.setSize(width, height);
  m_score.prepare(deadline.isLimited() && settings.searches);
  forgetImages();
  rough.clear();
  outcome.text = "no image was tracked yet";
}

void vpMultiCueEngine::captureStart(const vpCueFrame &image, const vpHomogeneousMatrix &cMo)
{
  const vpFrameContext frame = startOf(image);
  looks.setImage(image);
  const vpHomogeneousMatrix captured = m_capture.find(frame, cMo, 1.);
  m_learning.trust(captured);
  m_learning.learnStart(frame, captured);
  m_captured = captured;
}

bool vpMultiCueEngine::startRoughly(const vpCueFrame &image, const std::vector<vpWeightedPose> &candidates,
                                    const vpPoseDeviation &deviation, vpHomogeneousMatrix &cMo)
{
  rough.candidates = candidates;
  rough.spread = vpRoughStart::spreadOf(deviation, looks.model().diameter());
  return m_starter.search(startOf(image), cMo);
}

bool vpMultiCueEngine::startAnywhere(const vpCueFrame &image, const vpImageSearch::Sizes &sizes,
                                     vpHomogeneousMatrix &cMo)
{
  rough.anywhere = sizes;
  rough.spread = vpRoughStart::spreadOf(vpPoseDeviation(), looks.model().diameter());
  return m_starter.search(startOf(image), cMo);
}

// While the object is lost, or found again and not confirmed.
void vpMultiCueEngine::askDetector(const vpCueFrame &image)
{
  m_hints.forgetDetected();
  if (rough.detector && settings.searches && (outcome.isLost() || situation.mustConfirm)) {
    m_hints.askDetector(image);
  }
}

void vpMultiCueEngine::predict(vpHomogeneousMatrix &cMo)
{
  motion.predict({settings.searches, outcome.isLost(), situation.mustConfirm}, looks, symmetries,
                 m_learning.holdsTurns(), cMo);
  cues.edgePart().setRange(motion.predictedRange(looks, cues.edges().settings().range));
}

void vpMultiCueEngine::track(const vpCueFrame &image, vpHomogeneousMatrix &cMo)
{
  const vpFrameContext frame = frameOf(image);
  cMo = m_captured.value_or(cMo);
  m_captured.reset();
  edges.startFrame();
  situation.wasTracking = outcome.isTracking();
  m_score.prepare(deadline.isLimited() && settings.searches);
  looks.setImage(image);
  askDetector(image);
  if (!m_starter.resume(frame, settings.searches, cMo)) {
    return;
  }
  const vpHomogeneousMatrix before = cMo;
  predict(cMo);
  const bool compares = comparesAttempts();
  Found found = compares ? fuse(frame) : followEdges(frame, cMo, before);
  refuseUnbelievable(before, found);
  const double end = deadline.elapsed();
  cMo = found.cMo;
  m_learning.updateCovariance(cMo);
  m_watch.decide({cMo, found.best, found.best.cMo, m_verdict.agreement}, settings.searches);
  endFrame(frame, found, before, cMo);
  m_starter.confirm(frame, cMo);
  deadline.learnEnding(deadline.elapsed() - end);
}

// A minimisation that diverged ends anywhere, and what is left of the object there agrees with any image.
void vpMultiCueEngine::refuseUnbelievable(const vpHomogeneousMatrix &before, Found &found)
{
  const std::string why = vpPoseCheck::whyUnbelievable(looks.model(), found.cMo, looks.camera());
  if (!why.empty()) {
    outcome.setUnseen(why);
    m_attempts.forgetBest();
    found = {before, m_attempts.best()};
  }
}

// Attempts from one start after the other, and the best of them.
vpMultiCueEngine::Found vpMultiCueEngine::fuse(const vpFrameContext &frame)
{
  if (cues.isEdgesAlone()) {
    m_score.setFrame(frame);
    edges.clearHypotheses();
  }
  if (situation.mustConfirm) {
    m_watch.beginAfterLoss(motion.expected());
  }
  m_attempts.begin();
  m_knowledge.mostAgreeing = 0;
  m_knowledge.surface.setFrame(frame.image);
  m_plan.run(frame);
  compareTwins(frame);
  const vpEstimate estimate = m_attempts.settle(frame);
  m_verdict = m_attempts.verdict();
  outcome.judge(estimate.isFound, cues, minimiser.fusion(), settings.goodRatio);
  outcome.judgeShare(m_attempts.best().explained);
  outcome.usesPoints = estimate.usesPoints;
  m_explorer.update(frame, estimate.cMo, m_attempts.attempted());
  return {estimate.cMo, m_attempts.best()};
}

void vpMultiCueEngine::compareTwins(const vpFrameContext &frame)
{
  if (!m_attempts.hasBest() || situation.mustConfirm || m_twins.isOver() || deadline.putsOff(vpPutOff::COMPARISON)) {
    return;
  }
  bool hasMoved = false;
  const std::optional<vpHomogeneousMatrix> right = m_twinComparison.compare(frame, m_attempts.best().cMo, hasMoved);
  if (hasMoved) {
    m_attempts.noteMoved();
  }
  if (right) {
    m_watch.startOver(*right);
    m_attempts.forgetBest();
    m_attempts.attempt(frame, {*right, vpStart::FINE});
  }
}

vpMultiCueEngine::Found vpMultiCueEngine::followEdges(const vpFrameContext &frame, const vpHomogeneousMatrix &expected,
                                                      const vpHomogeneousMatrix &before)
{
  const bool explores = particles.settings().enabled;
  if (explores) {
    m_explorer.lookAround(frame, expected);
  }
  vpHomogeneousMatrix cMo = m_follower.follow(frame, expected, before);
  if (rough.hasHint) {
    cMo = m_follower.compareHint(frame, cMo);
  }
  if (explores) {
    cMo = m_explorer.weigh(frame, cMo);
  }
  if (settings.searches) {
    m_follower.judgeByMap(frame, cMo, explores);
  }
  m_verdict = m_follower.verdict();
  m_attempts.setOnly(cMo, m_verdict.explained);
  return {cMo, m_attempts.best()};
}

//! True where the pose may be learnt from. With edges alone, one that is followed without a loss: edges that are not
//! looked after are lost themselves.
bool vpMultiCueEngine::isTrusted() const
{
  const bool isFollowed = outcome.state == vpTrackingState::UNCERTAIN && cues.isEdgesAlone() && !settings.searches;
  return outcome.isTracking() || (isFollowed && !m_follower.mustConfirm());
}

void vpMultiCueEngine::endFrame(const vpFrameContext &frame, const Found &found, const vpHomogeneousMatrix &before,
                                vpHomogeneousMatrix &cMo)
{
  if (outcome.isLost()) {
    const bool coasts =
        motion.mayCoast() && vpPoseCheck::whyUnbelievable(looks.model(), motion.expected(), looks.camera()).empty();
    cMo = coasts ? motion.expected() : before;
    outcome.reason = coasts ? vpMbTrackingResult::Reason::COASTING : outcome.reason;
    for (const vpCueSet::Used &used : cues.used()) {
      used.cue->noteLoss(settings.searches);
    }
    particles.widen();
  } else if (isTrusted()) {
    particles.narrow();
    m_learning.learn(frame, cMo, m_verdict, found.best.value);
  } else if (!situation.mustConfirm) {
    m_learning.followDoubtful(cMo);
  }
}

END_VISP_NAMESPACE
