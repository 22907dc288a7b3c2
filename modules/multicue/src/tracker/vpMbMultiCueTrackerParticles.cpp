// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
// Room around the particles for what is optimised, shares of their size in the image.
const double regionMargin = 0.1;
// Levels of the view sphere. Where a view needs a depth buffer the finest ones would be more than a frame has time for:
// what hides what changes little between neighbours, and rims hardly move. Of the usual ones as many are made in a
// frame as here, and a coarser view stands in for the others.
const unsigned int usualLevel = 3;
const unsigned int coarseLevel = 2;
const unsigned int mostMade = 1;

// Those that were made before the start count as new ones: the same images give the same poses.
void makeViews(vpTrackerParticles &particles, const vpHomogeneousMatrix &bMo, vpViewSphere &sphere)
{
  particles.isViewed.resize(sphere.size(), 0);
  unsigned int made = 0;
  for (std::size_t i = 0; i < particles.filter().size() && made < mostMade; ++i) {
    const std::size_t view = sphere.nearest(particles.filter().pose(i) * bMo, usualLevel);
    if (particles.isViewed[view] == 0) {
      sphere.make(view);
      particles.isViewed[view] = 1;
      ++made;
    }
  }
}

// Widens a region to the object's sphere at a pose.
void include(const Eigen::Vector3d &centre, double radius, const vpCameraParameters &cam, Eigen::Array2d &low,
             Eigen::Array2d &high)
{
  if (!(centre.z() > radius)) {
    low.setConstant(-1e6);
    high.setConstant(1e6);
    return;
  }
  const Eigen::Array2d middle(cam.get_px() * centre.x() / centre.z() + cam.get_u0(),
                              cam.get_py() * centre.y() / centre.z() + cam.get_v0());
  const Eigen::Array2d reach = Eigen::Array2d(cam.get_px(), cam.get_py()) * (radius / centre.z());
  low = low.min(middle - reach);
  high = high.max(middle + reach);
}
} // namespace

void vpMbMultiCueTracker::setParticleSettings(const vpParticleSettings &settings)
{
  m_impl->particles.setSettings(settings);
  if (!settings.enabled) {
    m_impl->particles.clear();
  }
}

vpParticleSettings vpMbMultiCueTracker::getParticleSettings() const
{
  return m_impl->particles.settings();
}

std::vector<vpPoseParticle> vpMbMultiCueTracker::getParticles() const
{
  const vpPoseParticleFilter &filter = m_impl->particles.filter();
  std::vector<vpPoseParticle> particles(filter.size());
  if (particles.empty()) {
    return particles;
  }
  const vpHomogeneousMatrix bMo = m_impl->centreFrame().inverse();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles[i] = {filter.pose(i) * bMo, filter.weights()[i]};
  }
  return particles;
}

std::vector<vpPoseMode> vpMbMultiCueTracker::getPoseModes() const
{
  std::vector<vpPoseMode> modes = m_impl->particles.modes();
  if (modes.empty()) {
    return modes;
  }
  const vpHomogeneousMatrix oMb = m_impl->centreFrame();
  const vpPoseMatrix6 oVb = vpPoseExponential::adjoint(oMb);
  for (vpPoseMode &mode : modes) {
    mode.cMo = mode.cMo * oMb.inverse();
    mode.covariance = oVb * mode.covariance * oVb.transpose();
  }
  return modes;
}

vpHomogeneousMatrix vpMbMultiCueTracker::getParticleMean() const
{
  const vpTrackerParticles &particles = m_impl->particles;
  return particles.isStarted() ? particles.mean() * m_impl->centreFrame().inverse() : m_cMo;
}

void vpMbMultiCueTracker::setDisplayParticles(bool flag)
{
  m_impl->particles.isDisplayed = flag;
}

// To where they are expected in this frame.
void vpMbMultiCueTracker::moveParticles(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  const vpStopwatch stage(impl.timings.particles);
  const vpHomogeneousMatrix oMb = impl.centreFrame();
  const double diameter = impl.model->diameter();
  if (!particles.isStarted()) {
    particles.restart(impl.trusted.cMo * oMb, diameter);
    particles.follow(impl.trusted.cMo * oMb);
  }
  vpHomogeneousMatrix bMp;
  if (particles.settings().motion == vpParticleSettings::VELOCITY && impl.kalman.isStarted()) {
    bMp = oMb.inverse() * vpPoseExponential::exp(impl.kalman.velocity() * impl.frameInterval) * oMb;
  }
  particles.move(impl.frameInterval, bMp, impl.surprise, diameter);
  particles.frame = frame.number();
}

// The part of the image that shows the object at one of the particles' poses.
vpImageRegion vpMbMultiCueTracker::particleRegion(const vpCueFrame &frame) const
{
  const Impl &impl = *m_impl;
  const vpPoseParticleFilter &filter = impl.particles.filter();
  const double radius = 0.5 * impl.model->diameter();
  Eigen::Array2d low = Eigen::Array2d::Constant(HUGE_VAL);
  Eigen::Array2d high = -low;
  for (std::size_t i = 0; i < filter.predictedSize(); ++i) {
    const vpHomogeneousMatrix &cMb = filter.pose(i);
    include({cMb[0][3], cMb[1][3], cMb[2][3]}, radius, frame.camera(), low, high);
  }
  const Eigen::Array2d margin = regionMargin * (high - low) + impl.distanceMap.settings().maxDistance;
  low = (low - margin).max(0.).min(Eigen::Array2d(frame.width(), frame.height()));
  high = (high + margin).max(0.).min(Eigen::Array2d(frame.width(), frame.height()));
  const Eigen::Array2i corner = low.floor().cast<int>();
  const Eigen::Array2i size = high.ceil().cast<int>() - corner;
  return {corner.x(), corner.y(), size.x(), size.y()};
}

// With edges alone: propagation and optimisation of the best ([T10] III-E), before the pose is estimated. That then
// goes on from the pose before as without particles: theirs is not taken before several frames speak for it.
void vpMbMultiCueTracker::lookAround(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  moveParticles(frame);
  impl.scoreRegion(frame, particleRegion(frame));
  {
    const vpStopwatch stage(impl.timings.particles);
    if (!impl.model->isConvex()) {
      makeViews(particles, impl.centreFrame().inverse(), impl.viewSphere());
    }
    particles.values.clear();
    for (std::size_t i = 0; i < particles.filter().size(); ++i) {
      particles.values.push_back(distanceAt(particles.filter().pose(i)));
    }
  }
  const bool isCalm = particles.isCalm && !impl.rough.hasHint;
  particles.before = {isCalm, impl.draws, particles.draws, m_cMo,
                      isCalm ? particles.rivals : std::vector<vpRivalPose>()};
  optimiseAround(frame);
}

// The weights of [T10] III-E, and what they say of the pose.
void vpMbMultiCueTracker::weighParticles(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  if (particles.before.isCalm && !impl.explains(impl.bestResidue())) {
    lookAgain(frame);
  }
  impl.minimisations += particles.minimisations;
  compareRivals(frame);
  const vpStopwatch stage(impl.timings.particles);
  const vpHomogeneousMatrix oMb = impl.centreFrame();
  takeHypotheses();
  if (impl.state != vpTrackingState::LOST) {
    particles.proposals.push_back(m_cMo * oMb);
  }
  particles.proposalValues.clear();
  for (const vpHomogeneousMatrix &cMb : particles.proposals) {
    particles.proposalValues.push_back(distanceAt(cMb));
  }
  if (!particles.weighDistances(particles.values, particles.proposals, particles.proposalValues)) {
    particles.restart(impl.trusted.cMo * oMb, impl.model->diameter());
    return;
  }
  particles.findModes(impl.model->diameter());
  takeParticleMean();
}

// Where the mean itself is asked for, the estimation from there only tells how well it fits.
void vpMbMultiCueTracker::takeParticleMean()
{
  const vpTrackerParticles &particles = m_impl->particles;
  if (particles.settings().enabled && particles.settings().output == vpParticleSettings::MEAN &&
      particles.isStarted()) {
    m_cMo = particles.mean() * m_impl->centreFrame().inverse();
  }
}

// [T10] eq. 11.
double vpMbMultiCueTracker::distanceAt(const vpHomogeneousMatrix &cMb) const
{
  const vpHomogeneousMatrix cMo = cMb * m_impl->centreFrame().inverse();
  vpViewSphere &sphere = m_impl->viewSphere();
  unsigned int level = sphere.options().level;
  if (!m_impl->model->isConvex()) {
    const std::size_t view = sphere.nearest(cMo, usualLevel);
    const std::vector<char> &isViewed = m_impl->particles.isViewed;
    level = view < isViewed.size() && isViewed[view] != 0 ? usualLevel : coarseLevel;
  }
  const vpPoseScore::Value value = m_impl->poseScore.at(cMo, level);
  return value.isSeen ? value.distance : vpTrackerParticles::impossible;
}

// With several cues: particles follow what was estimated, and tell what else the image allows.
void vpMbMultiCueTracker::updateParticles(const vpCueFrame &frame, const std::vector<vpHomogeneousMatrix> &proposals)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  if (!particles.settings().enabled) {
    return;
  }
  const vpHomogeneousMatrix oMb = impl.centreFrame();
  moveParticles(frame);
  if (impl.scoredFrame != frame.number()) {
    impl.scoreRegion(frame, particleRegion(frame));
  }
  const vpStopwatch stage(impl.timings.particles);
  const auto logAt = [&](const vpHomogeneousMatrix &cMo) {
    const vpPoseScore::Value value = impl.poseScore(cMo);
    return value.isSeen ? particles.settings().sharpness * value.total : -HUGE_VAL;
  };
  particles.values.clear();
  for (std::size_t i = 0; i < particles.filter().size(); ++i) {
    particles.values.push_back(logAt(particles.filter().pose(i) * oMb.inverse()));
  }
  particles.proposals.clear();
  particles.proposalValues.clear();
  for (const vpHomogeneousMatrix &cMo : proposals) {
    particles.proposals.push_back(cMo * oMb);
    particles.proposalValues.push_back(logAt(cMo));
  }
  const bool isPossible = particles.weigh(particles.values, particles.proposals, particles.proposalValues);
  particles.follow(m_cMo * oMb);
  // An object that was found elsewhere is beyond their reach.
  if (!isPossible ||
      (impl.state == vpTrackingState::TRACKING && !particles.reach(m_cMo * oMb, impl.model->diameter()))) {
    particles.restart(m_cMo * oMb, impl.model->diameter());
  }
  particles.findModes(impl.model->diameter());
}

END_VISP_NAMESPACE
