// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "hypotheses/vpControlPointMotion.h"
#include "frame/vpStopwatch.h"
#include "tracker/vpTrackerState.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
// Draws that are minimised from one particle.
const unsigned int drawsEach = 2;
// Control points of their views are as many times farther apart.
const double coarseness = 2.;
// Particles that are optimised while the pose explains the image.
const unsigned int fewOptimised = 2;
// What hides what changes little for poses that move the control points by less than this about the object's middle.
const double sameDepth = 2.5; // Pixels.
} // namespace

// The best particles and the rivals. The estimation from the pose before has random numbers and minimisations of its
// own, and does the same as without particles.
void vpMbMultiCueTracker::optimiseAround(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  const vpHomogeneousMatrix cMo = m_cMo;
  std::swap(impl.draws, particles.draws);
  optimiseParticles(frame);
  optimiseRivals(frame);
  std::swap(impl.draws, particles.draws);
  particles.minimisations = impl.minimisations;
  impl.minimisations = 0;
  m_cMo = cMo;
}

// Few particles were optimised, as the frame before was explained, and this one is not: all of it again with as many as
// are set.
void vpMbMultiCueTracker::lookAgain(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  const unsigned int minimisations = impl.minimisations + particles.minimisations;
  impl.draws = particles.before.draws;
  impl.minimisations = 0;
  particles.draws = particles.before.particleDraws;
  particles.rivals = particles.before.rivals;
  particles.before.isCalm = false;
  m_cMo = particles.before.cMo;
  optimiseAround(frame);
  particles.minimisations += minimisations;
  judge(estimate(frame));
}

// True where the depth buffer of this frame tells what hides what at a pose, too. It is looked into where the object's
// middle has gone, so that only the motion about that counts.
bool vpMbMultiCueTracker::servesDepth(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo) const
{
  const Impl &impl = *m_impl;
  const vpModelView &view = *impl.view;
  return impl.viewedFrame == frame.number() && !view.points().empty() && view.depth() != nullptr &&
         vpControlPointMotion::aroundMiddle(view, view.depthPose(), cMo, frame.camera()) < sameDepth;
}

// A pose among others of the same frame.
void vpMbMultiCueTracker::matchNear(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo)
{
  computeView(frame, cMo, servesDepth(frame, cMo));
  matchView(frame);
}

// Optimised particles need no more than half of the control points: what comes of them is estimated again with all.
void vpMbMultiCueTracker::viewCoarsely(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo)
{
  Impl &impl = *m_impl;
  const vpStopwatch stage(impl.timings.view);
  vpModelView &view = *impl.view;
  const bool keepsDepth = servesDepth(frame, cMo);
  vpModelViewOptions options = viewOptions();
  options.sampleStep *= coarseness;
  view.compute(cMo, frame.camera(), frame.width(), frame.height(), options, impl.renderer.get(), keepsDepth);
  impl.viewedFrame = frame.number();
}

// What pose hypotheses make of the best particles.
void vpMbMultiCueTracker::optimiseParticles(const vpCueFrame &frame)
{
  Impl &impl = *m_impl;
  vpTrackerParticles &particles = impl.particles;
  const vpHomogeneousMatrix oMb = impl.centreFrame();
  const unsigned int all = particles.settings().mostOptimised;
  const unsigned int most = particles.before.isCalm ? std::min(all, fewOptimised) : all;
  const std::vector<std::size_t> best = particles.best(particles.values, m_cMo * oMb, impl.model->diameter(), most);
  particles.proposals.clear();
  particles.residues.clear();
  impl.restrictHypotheses(oJo);
  for (const std::size_t i : best) {
    m_cMo = particles.filter().pose(i) * oMb.inverse();
    viewCoarsely(frame, m_cMo);
    matchView(frame);
    if (findPoses(drawsEach, HUGE_VAL)) {
      takeHypotheses();
    }
  }
}

void vpMbMultiCueTracker::takeHypotheses()
{
  Impl &impl = *m_impl;
  for (const vpPoseHypothesis &hypothesis : impl.hypotheses.hypotheses()) {
    impl.particles.proposals.push_back(hypothesis.cMo * impl.centreFrame());
    impl.particles.residues.push_back(hypothesis.residue);
  }
}

END_VISP_NAMESPACE
