// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpControlPointMotion.h"
#include "motion/vpPoseCheck.h"
#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// When the pose moved the control points by more than this, normals and neighbourhoods have changed: match again.
const double rematchMotion = 1.5; // Pixels.
const unsigned int maxMatches = 3;
// Of a pose that is followed but not trusted: the filter takes its covariance times this.
const double doubtOfMotion = 10.;
const double mostOfMotion = 4.; // Squared distance from the expected pose, in deviations; beyond it, it jumped.
// What hides what changes little for poses that move the control points by less than this, pixels.
const double sameDepth = 2.5;

// A pose that moved its control points by more than this many search ranges in one match has diverged.
const double maxMotion = 2.;
} // namespace

vpMbMultiCueTracker::vpMbMultiCueTracker(vpTrackerType type) : m_impl(std::make_unique<Impl>())
{
  setTrackerType(type);
}

vpMbMultiCueTracker::~vpMbMultiCueTracker() = default;

void vpMbMultiCueTracker::requireTrackable(unsigned int width, unsigned int height) const
{
  m_impl->requireModel();
  if (width == 0 || height == 0) {
    throw vpException(vpException::dimensionError, "The image is empty (%u x %u): give one with pixels", width, height);
  }
}

void vpMbMultiCueTracker::start(unsigned int width, unsigned int height)
{
  requireTrackable(width, height);
  const vpHomogeneousMatrix cMo = m_cMo;
  m_cMo = m_impl->trusted.cMo; // Until the new pose has passed.
  vpPoseCheck::requireRigid(cMo);
  vpPoseCheck::requireInView(*m_impl->model, cMo, m_cam, width, height);
  m_cMo = cMo;
  m_impl->trust(cMo);
  m_impl->width = width;
  m_impl->height = height;
  m_impl->forgetImages();
  m_impl->rough.clear();
  m_impl->state = vpTrackingState::UNCERTAIN;
  m_impl->reason = "no image was tracked yet";
}

template <typename Pixel> void vpMbMultiCueTracker::startOn(const vpImage<Pixel> &I)
{
  start(I.getWidth(), I.getHeight());
  captureStart(m_impl->source.frame(I, m_cam, m_mask));
  followFaces(I.getWidth(), I.getHeight());
}

template void vpMbMultiCueTracker::startOn(const vpImage<unsigned char> &I);
template void vpMbMultiCueTracker::startOn(const vpImage<vpRGBa> &I);

void vpMbMultiCueTracker::init(const vpImage<unsigned char> &I)
{
  startOn(I);
}

template <typename Pixel> void vpMbMultiCueTracker::trackImage(const vpImage<Pixel> &I)
{
  requireTrackable(I.getWidth(), I.getHeight());
  vpTrackingTimings &timings = m_impl->timings;
  m_impl->particles.adaptNumber(timings);
  m_impl->searchBudget.startFrame();
  timings = vpTrackingTimings();
  const vpStopwatch whole(timings.total);
  const auto makeFrame = [this, &I, &timings] {
    const vpStopwatch stage(timings.frame);
    return m_impl->source.frame(I, m_cam, m_mask);
  };
  const vpCueFrame frame = makeFrame();
  trackFrame(frame);
  updateProjectionError(frame);
  followFaces(I.getWidth(), I.getHeight());
}

void vpMbMultiCueTracker::track(const vpImage<unsigned char> &I)
{
  trackImage(I);
}

void vpMbMultiCueTracker::track(const vpImage<vpRGBa> &I_color)
{
  trackImage(I_color);
}

void vpMbMultiCueTracker::trackFrame(const vpCueFrame &frame)
{
  if (m_impl->width == 0) {
    throw vpException(vpException::notInitialized,
                      "No initial pose: call initFromPose(), initClick() or initFromPoints() first");
  }
  if (frame.width() != m_impl->width || frame.height() != m_impl->height) {
    throw vpException(vpException::dimensionError,
                      "The image is %u x %u, the tracker was started with %u x %u: initialise again for another size",
                      frame.width(), frame.height(), m_impl->width, m_impl->height);
  }
  Impl &impl = *m_impl;
  if (impl.captured) {
    m_cMo = *impl.captured;
    impl.captured.reset();
  }
  impl.minimisations = 0;
  impl.wasTracking = impl.state == vpTrackingState::TRACKING;
  impl.frameCamera = frame.camera();
  askDetector(frame);
  if (!resumeStart(frame)) {
    impl.rough.hasHint = false;
    if (impl.throwOnLoss) {
      testTracking();
    }
    return;
  }
  const vpHomogeneousMatrix cMoBefore = m_cMo;
  predict();
  const bool compares = impl.comparesAttempts();
  const bool explores = !compares && impl.particles.settings().enabled;
  if (explores) {
    lookAround(frame);
  }
  if (compares) {
    judge(estimate(frame));
  } else {
    followEdges(frame, cMoBefore);
  }
  if (impl.rough.hasHint && !compares) {
    compareHint(frame);
  }
  if (explores) {
    weighParticles(frame);
  } else if (compares) {
    updateParticles(frame, impl.attempted);
  }
  if (!compares && impl.searches) {
    judgeByMap(frame);
  }
  updateCovariance();
  impl.chooseTrack();
  confirm();
  believe();
  impl.endTracks(m_cMo);
  if (impl.state == vpTrackingState::LOST) {
    const bool coasts = impl.mayCoast();
    m_cMo = coasts ? impl.expectedPose : cMoBefore;
    impl.outcome = coasts ? vpMbTrackingResult::Reason::COASTING : impl.outcome;
    impl.edges.reset();
    if (impl.points && impl.searches) {
      impl.points->reset(); // They followed something else.
    }
    impl.particles.widen();
  } else if (impl.isTrusted()) {
    impl.particles.narrow();
    learn(frame);
  } else if (!impl.mustConfirm) {
    followDoubtful();
  }
  confirmStart(frame);
  if (m_impl->throwOnLoss) {
    testTracking();
  }
}

// The pose that is not trusted may be the one that was followed: how it moves is known.
void vpMbMultiCueTracker::followDoubtful()
{
  Impl &impl = *m_impl;
  if (impl.surpriseAt(m_cMo) < mostOfMotion) {
    updateMotion(doubtOfMotion);
  } else if (impl.predicts) {
    impl.forgetMotion();
  }
}

// Only from poses that are trusted: what is learnt from a wrong one keeps it wrong.
void vpMbMultiCueTracker::learn(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  ++impl.trustedFrames;
  updateReferences();
  impl.learnResidue();
  if (impl.state == vpTrackingState::TRACKING) {
    learnUsual();
  }
  if (impl.type != EDGE_TRACKER) {
    learnKeyframe(frame);
  }
  learnSurprise();
  updateMotion();
  impl.trust(m_cMo, impl.kalman.velocity());
  impl.keepLearnt();
  if (impl.kalman.isStarted()) {
    impl.inertia.update(
        {m_cMo, impl.kalman.velocity(), impl.time, {std::sqrt(impl.surprise[0]), std::sqrt(impl.surprise[1])}});
  }
}

void vpMbMultiCueTracker::computeView(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, bool keepDepth)
{
  Impl &impl = *m_impl;
  const vpStopwatch stage(impl.timings.view);
  impl.view->compute(cMo, frame.camera(), frame.width(), frame.height(), viewOptions(), impl.renderer.get(), keepDepth);
  impl.viewedFrame = frame.number();
}

// Keeps a view of this frame that is near enough, pixels.
void vpMbMultiCueTracker::updateView(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, double near)
{
  const vpModelView &view = *m_impl->view;
  // A view without points, of a pose beside the image, tells nothing of how far another one is from it.
  const bool isOfFrame = m_impl->viewedFrame == frame.number() && !view.points().empty();
  if (isOfFrame && vpControlPointMotion::mean(view, cMo, frame.camera()) <= near) {
    return;
  }
  const bool keepDepth =
      isOfFrame && vpControlPointMotion::between(view, view.depthPose(), cMo, frame.camera()) < sameDepth;
  computeView(frame, cMo, keepDepth);
}

void vpMbMultiCueTracker::match(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo)
{
  computeView(frame, cMo);
  matchView(frame);
}

void vpMbMultiCueTracker::matchView(const vpCueFrame &frame)
{
  const vpStopwatch stage(m_impl->timings.match);
  m_impl->edges.match(frame, *m_impl->view);
}

bool vpMbMultiCueTracker::estimate(const vpCueFrame &frame)
{
  if (m_impl->comparesAttempts()) {
    return estimateFused(frame);
  }
  return estimateFrom(frame, m_impl->hypotheses.settings().enabled && proposePose(frame));
}

// \param matched True where the last match serves m_cMo.
bool vpMbMultiCueTracker::estimateFrom(const vpCueFrame &frame, bool matched)
{
  const double limit = maxMotion * m_impl->edges.settings().range;
  for (unsigned int i = 0; i < maxMatches; ++i) {
    if (!matched) {
      match(frame, m_cMo);
    }
    matched = false;
    if (!minimise({EDGE_TRACKER}) || !vpPoseCheck::isFinite(m_cMo)) {
      return false;
    }
    const double motion = vpControlPointMotion::mean(*m_impl->view, m_cMo, frame.camera());
    if (motion > limit) {
      return false;
    }
    if (motion < rematchMotion) {
      break;
    }
  }
  return true;
}

END_VISP_NAMESPACE
