// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "facade/vpTrackerImpl.h"
#include "motion/vpPoseCheck.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

template <typename Pixel>
double vpMbMultiCueTracker::Impl::scoreOn(const vpImage<Pixel> &I, const vpHomogeneousMatrix &cMo)
{
  requireTrackable(I.getWidth(), I.getHeight());
  vpPoseCheck::requireRigid(cMo);
  try {
    vpPoseCheck::requireInView(m_engine.looks.model(), cMo, m_tracker.m_cam, I.getWidth(), I.getHeight());
  } catch (const vpException &) {
    return 0.; // No image shows it.
  }
  handOver();
  vpAnyPoseScore::Looks looks;
  looks.model = m_engine.looks.pointer();
  looks.preference = m_engine.looks.preference();
  looks.options = m_engine.looks.options;
  looks.edges = m_engine.cues.edges().settings();
  looks.colors = m_engine.cues.color().settings();
  if (m_engine.cues.knowsColors()) {
    looks.learnt = m_engine.cues.color().reference();
  }
  return m_anyScore(m_scoredImage.frame(I, m_tracker.m_cam, m_tracker.m_mask), cMo, looks);
}

double vpMbMultiCueTracker::score(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo) const
{
  return m_impl->scoreOn(I, cMo);
}

double vpMbMultiCueTracker::score(const vpImage<vpRGBa> &I_color, const vpHomogeneousMatrix &cMo) const
{
  return m_impl->scoreOn(I_color, cMo);
}

END_VISP_NAMESPACE
