// SPDX-License-Identifier: GPL-2.0-or-later
#include "particles/vpParticleExplorer.h"

#include "frame/vpStopwatch.h"

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

// To where they are expected in this frame.
void vpParticleExplorer::move(const vpFrameContext &frame)
{
  const vpStopwatch stage(frame.timings.particles);
  const vpHomogeneousMatrix oMb = m_looks.centreFrame();
  const double diameter = m_looks.model().diameter();
  if (!m_particles.isStarted()) {
    m_particles.restart(m_motion.trusted.cMo * oMb, diameter);
    m_particles.follow(m_motion.trusted.cMo * oMb);
  }
  vpHomogeneousMatrix bMp;
  if (m_particles.settings().motion == vpParticleSettings::VELOCITY && m_motion.kalman.isStarted()) {
    bMp = oMb.inverse() * vpPoseExponential::exp(m_motion.kalman.velocity() * m_motion.frameInterval) * oMb;
  }
  m_particles.move(m_motion.frameInterval, bMp, m_motion.surprise(), diameter);
  m_particles.frame = frame.image.number();
}

// The part of the image that shows the object at one of the particles' poses.
vpImageRegion vpParticleExplorer::region(const vpCueFrame &image) const
{
  const vpPoseParticleFilter &filter = m_particles.filter();
  const double radius = 0.5 * m_looks.model().diameter();
  Eigen::Array2d low = Eigen::Array2d::Constant(HUGE_VAL);
  Eigen::Array2d high = -low;
  for (std::size_t i = 0; i < filter.predictedSize(); ++i) {
    const vpHomogeneousMatrix &cMb = filter.pose(i);
    include({cMb[0][3], cMb[1][3], cMb[2][3]}, radius, image.camera(), low, high);
  }
  const Eigen::Array2d margin = regionMargin * (high - low) + m_score.distances().settings().maxDistance;
  low = (low - margin).max(0.).min(Eigen::Array2d(image.width(), image.height()));
  high = (high + margin).max(0.).min(Eigen::Array2d(image.width(), image.height()));
  const Eigen::Array2i corner = low.floor().cast<int>();
  const Eigen::Array2i size = high.ceil().cast<int>() - corner;
  return {corner.x(), corner.y(), size.x(), size.y()};
}

void vpParticleExplorer::lookAround(const vpFrameContext &frame, const vpHomogeneousMatrix &expected)
{
  move(frame);
  m_score.setRegion(frame, region(frame.image));
  {
    const vpStopwatch stage(frame.timings.particles);
    if (!m_looks.model().isConvex()) {
      makeViews(m_particles, m_looks.centreFrame().inverse(), m_score.sphere());
    }
    m_particles.values.clear();
    for (std::size_t i = 0; i < m_particles.filter().size(); ++i) {
      m_particles.values.push_back(distanceAt(m_particles.filter().pose(i)));
    }
  }
  const bool isCalm = m_particles.isCalm && !m_rough.hasHint;
  m_particles.before = {isCalm, frame.streams.searches, m_particles.draws, expected,
                        isCalm ? m_particles.rivals : std::vector<vpRivalPose>()};
  m_rivals.optimise(frame, expected);
}

vpHomogeneousMatrix vpParticleExplorer::weigh(const vpFrameContext &frame, const vpHomogeneousMatrix &estimated)
{
  vpHomogeneousMatrix cMo = estimated;
  if (m_particles.before.isCalm && !m_edges.explains(m_edges.bestResidue())) {
    cMo = m_rivals.lookAgain(frame);
  }
  m_edges.setMinimisations(m_edges.minimisations() + m_particles.minimisations);
  cMo = m_rivals.compare(frame, cMo);
  const vpStopwatch stage(frame.timings.particles);
  const vpHomogeneousMatrix oMb = m_looks.centreFrame();
  m_rivals.takeHypotheses();
  if (!m_outcome.isLost()) {
    m_particles.proposals.push_back(cMo * oMb);
  }
  m_particles.proposalValues.clear();
  for (const vpHomogeneousMatrix &cMb : m_particles.proposals) {
    m_particles.proposalValues.push_back(distanceAt(cMb));
  }
  if (!m_particles.weighDistances(m_particles.values, m_particles.proposals, m_particles.proposalValues)) {
    m_particles.restart(m_motion.trusted.cMo * oMb, m_looks.model().diameter());
    return cMo;
  }
  m_particles.findModes(m_looks.model().diameter());
  // Where the mean itself is asked for, the estimation from there only tells how well it fits.
  const bool isMean = m_particles.settings().output == vpParticleSettings::MEAN && m_particles.isStarted();
  return isMean ? m_particles.mean() * oMb.inverse() : cMo;
}

// [T10] eq. 11.
double vpParticleExplorer::distanceAt(const vpHomogeneousMatrix &cMb) const
{
  const vpHomogeneousMatrix cMo = cMb * m_looks.centreFrame().inverse();
  const vpViewSphere &sphere = m_score.sphere();
  unsigned int level = sphere.options().level;
  if (!m_looks.model().isConvex()) {
    const std::size_t view = sphere.nearest(cMo, usualLevel);
    const std::vector<char> &isViewed = m_particles.isViewed;
    level = view < isViewed.size() && isViewed[view] != 0 ? usualLevel : coarseLevel;
  }
  const vpPoseScore::Value value = m_score.score().at(cMo, level);
  return value.isSeen ? value.distance : vpTrackerParticles::impossible;
}

void vpParticleExplorer::update(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo,
                                const std::vector<vpHomogeneousMatrix> &proposals)
{
  if (!m_particles.settings().enabled) {
    return;
  }
  const vpHomogeneousMatrix oMb = m_looks.centreFrame();
  const double diameter = m_looks.model().diameter();
  move(frame);
  if (!m_score.hasWhole(frame)) {
    m_score.setRegion(frame, region(frame.image));
  }
  const vpStopwatch stage(frame.timings.particles);
  const auto logAt = [this](const vpHomogeneousMatrix &pose) {
    const vpPoseScore::Value value = m_score(pose);
    return value.isSeen ? m_particles.settings().sharpness * value.total : -HUGE_VAL;
  };
  m_particles.values.clear();
  for (std::size_t i = 0; i < m_particles.filter().size(); ++i) {
    m_particles.values.push_back(logAt(m_particles.filter().pose(i) * oMb.inverse()));
  }
  m_particles.proposals.clear();
  m_particles.proposalValues.clear();
  for (const vpHomogeneousMatrix &proposal : proposals) {
    m_particles.proposals.push_back(proposal * oMb);
    m_particles.proposalValues.push_back(logAt(proposal));
  }
  const bool isPossible = m_particles.weigh(m_particles.values, m_particles.proposals, m_particles.proposalValues);
  m_particles.follow(cMo * oMb);
  // An object that was found elsewhere is beyond their reach.
  if (!isPossible || (m_outcome.isTracking() && !m_particles.reach(cMo * oMb, diameter))) {
    m_particles.restart(cMo * oMb, diameter);
  }
  m_particles.findModes(diameter);
}

END_VISP_NAMESPACE
