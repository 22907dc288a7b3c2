// SPDX-License-Identifier: GPL-2.0-or-later
#include "facade/vpTrackerImpl.h"
#include "frame/vpStopwatch.h"
#include "motion/vpPoseCheck.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpTrackingException.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
void requireImage(unsigned int width, unsigned int height)
{
  if (width == 0 || height == 0) {
    throw vpException(vpException::dimensionError, "The image is empty (%u x %u): give one with pixels", width, height);
  }
}
} // namespace

vpMbMultiCueTracker::vpMbMultiCueTracker(vpTrackerType type) : m_impl(std::make_unique<Impl>(*this))
{
  setTrackerType(type);
}

vpMbMultiCueTracker::~vpMbMultiCueTracker() = default;

vpMbMultiCueTracker::Impl::Impl(vpMbMultiCueTracker &tracker)
    : m_tracker(tracker), m_servoing(tracker), m_engine(m_servoing)
{
  updateMe();
}

bool vpMbMultiCueTracker::Impl::Servoing::mustRestart(unsigned int iteration, Step &step)
{
  bool restart = false;
  m_tracker.computeVVSCheckLevenbergMarquardt(iteration, m_tracker.m_error, step.errorBefore, step.cMoBefore,
                                              step.damping, restart);
  return restart;
}

void vpMbMultiCueTracker::Impl::Servoing::solve(bool allMotions, unsigned int iteration, Step &step)
{
  m_tracker.computeVVSPoseEstimation(allMotions, iteration, m_tracker.m_L, step.LTL, step.weightedError,
                                     m_tracker.m_error, step.errorBefore, step.LTR, step.damping, step.velocity);
}

void vpMbMultiCueTracker::computeVVSInit()
{
  m_impl->engine().minimiser.start(m_impl->engine().cues.factors);
}

void vpMbMultiCueTracker::computeVVSInteractionMatrixAndResidu()
{
  m_impl->engine().minimiser.evaluate();
}

void vpMbMultiCueTracker::Impl::requireTrackable(unsigned int width, unsigned int height) const
{
  m_engine.looks.requireModel();
  requireImage(width, height);
}

void vpMbMultiCueTracker::Impl::requireStart(unsigned int width, unsigned int height, const vpTrackedModel &model,
                                             const vpHomogeneousMatrix &cMo) const
{
  requireImage(width, height);
  vpPoseCheck::requireRigid(cMo);
  vpPoseCheck::requireInView(model, cMo, m_tracker.m_cam, width, height);
}

// A detector is wrong at times, and a loop that takes its poses has to go on.
bool vpMbMultiCueTracker::Impl::isFollowable(const vpHomogeneousMatrix &cMo, unsigned int width, unsigned int height)
{
  requireTrackable(width, height);
  vpPoseCheck::requireRigid(cMo);
  try {
    vpPoseCheck::requireInView(m_engine.looks.model(), cMo, m_tracker.m_cam, width, height);
  } catch (const vpException &e) {
    m_engine.outcome.setUnseen(e.getMessage());
    return false;
  }
  return true;
}

void vpMbMultiCueTracker::Impl::start(const vpHomogeneousMatrix &cMo, unsigned int width, unsigned int height)
{
  requireStart(width, height, m_engine.looks.model(), cMo);
  m_tracker.m_cMo = cMo;
  m_engine.start(width, height, cMo);
}

template <typename Pixel> void vpMbMultiCueTracker::Impl::startOn(const vpImage<Pixel> &I)
{
  const vpHomogeneousMatrix given = m_tracker.m_cMo;
  m_tracker.m_cMo = m_engine.motion.trusted.cMo; // Until the new pose has passed.
  requireTrackable(I.getWidth(), I.getHeight());
  // A mask of another size is refused before anything is forgotten.
  const vpCueFrame image = source.frame(I, m_tracker.m_cam, m_tracker.m_mask);
  start(given, I.getWidth(), I.getHeight());
  estimate([&](const vpHomogeneousMatrix &cMo) { m_engine.captureStart(image, cMo); });
  m_tracker.followFaces(I.getWidth(), I.getHeight());
}

template void vpMbMultiCueTracker::Impl::startOn(const vpImage<unsigned char> &);
template void vpMbMultiCueTracker::Impl::startOn(const vpImage<vpRGBa> &);

void vpMbMultiCueTracker::init(const vpImage<unsigned char> &I)
{
  m_impl->startOn(I);
}

template <typename Pixel>
void vpMbMultiCueTracker::Impl::setPoseOn(const vpImage<Pixel> &I, const vpHomogeneousMatrix &cdMo)
{
  if (isFollowable(cdMo, I.getWidth(), I.getHeight())) {
    m_tracker.m_cMo = cdMo;
    startOn(I);
  }
}

void vpMbMultiCueTracker::setPose(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cdMo)
{
  m_impl->setPoseOn(I, cdMo);
}

void vpMbMultiCueTracker::setPose(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cdMo)
{
  m_impl->setPoseOn(I_color, cdMo);
}

template <typename Pixel> void vpMbMultiCueTracker::Impl::trackOn(const vpImage<Pixel> &I)
{
  const unsigned int width = I.getWidth();
  const unsigned int height = I.getHeight();
  requireTrackable(width, height);
  if (m_engine.looks.width() == 0) {
    throw vpException(vpException::notInitialized,
                      "No initial pose: call initFromPose(), initClick() or initFromPoints() first");
  }
  if (width != m_engine.looks.width() || height != m_engine.looks.height()) {
    throw vpException(vpException::dimensionError,
                      "The image is %u x %u, the tracker was started with %u x %u: initialise again for another size",
                      width, height, m_engine.looks.width(), m_engine.looks.height());
  }
  vpTrackingTimings &timings = m_engine.timings;
  m_engine.particles.adaptNumber(timings);
  m_engine.deadline.startFrame();
  timings = vpTrackingTimings();
  const vpStopwatch whole(timings.total);
  const auto makeFrame = [&] {
    const vpStopwatch stage(timings.frame);
    return source.frame(I, m_tracker.m_cam, m_tracker.m_mask);
  };
  const vpCueFrame image = makeFrame();
  estimate([&](vpHomogeneousMatrix &cMo) { m_engine.track(image, cMo); });
  m_engine.outcome.failure = m_engine.looks.newFailure();
  if (m_tracker.computeCovariance) {
    m_tracker.covarianceMatrix = m_engine.covariance.ofParameters();
  }
  if (throwOnLoss) {
    m_tracker.testTracking();
  }
  updateProjectionError(image);
  m_tracker.followFaces(width, height);
}

void vpMbMultiCueTracker::track(const vpImage<unsigned char> &I)
{
  m_impl->trackOn(I);
}

void vpMbMultiCueTracker::track(const vpImage<vpRGBa> &I_color)
{
  m_impl->trackOn(I_color);
}

void vpMbMultiCueTracker::testTracking()
{
  if (m_impl->engine().outcome.isLost()) {
    throw vpTrackingException(vpTrackingException::fatalError, "The object is lost: " + m_impl->engine().outcome.text);
  }
}

END_VISP_NAMESPACE
