// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/vpNearSearch.h"

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t nearNumber = 80;
const std::size_t scoredNumber = 400; // Where colours do not help, from the near spread and from a wider one each.
const double widerFactor = 1.6;
const std::size_t modeNumber = 10; // Around each mode of the particles.
// Turns of the object that are tried, radians.
const double angleOfTurn = 0.35;
} // namespace

void vpNearSearch::search(const vpFrameContext &frame)
{
  const vpHomogeneousMatrix &expected = m_motion.expected();
  const vpPoseSearch::Spread near = vpPoseSearch::near();
  m_score.setFrame(frame);
  vpPoseSearch search(m_score.score(), m_looks.model(), frame.streams.searches++);
  search.setSymmetries(m_symmetries.get());
  search.setPrior(expected, near, vpPoseSearch::usualPrior);
  search.scatter({expected}, near, nearNumber);
  const vpHomogeneousMatrix bMo = m_looks.centreFrame().inverse();
  for (const vpPoseMode &mode : m_particles.modes()) { // What the frames before left open.
    search.scatter({mode.cMo * bMo}, vpPoseSearch::same(), modeNumber);
  }
  m_score.settle(search);
  if (m_attempts.attemptBest(frame, search) || frame.budget.isSpent()) {
    return;
  }
  // Colours led away from the object, or there are none.
  vpPoseSearch again(m_score.score(), m_looks.model(), frame.streams.searches++);
  again.setSymmetries(m_symmetries.get());
  const vpPoseSearch::Spread wider = near.grown(widerFactor);
  again.setPrior(expected, wider, vpPoseSearch::usualPrior);
  again.scatter({expected}, near, scoredNumber);
  again.scatter({expected}, wider, scoredNumber);
  m_score.settleByScore(again);
  m_attempts.attemptBest(frame, again, false);
}

void vpNearSearch::turn(const vpFrameContext &frame)
{
  const vpHomogeneousMatrix expected = m_motion.expected();
  const vpHomogeneousMatrix oMb = m_looks.centreFrame();
  const vpHomogeneousMatrix cMb = expected * oMb;
  for (unsigned int i = 0; i < 6; ++i) {
    const double angle = i % 2 == 0 ? angleOfTurn : -angleOfTurn;
    const unsigned int axis = i / 2;
    const vpHomogeneousMatrix turned(
        vpTranslationVector(cMb[0][3], cMb[1][3], cMb[2][3]),
        vpRotationMatrix(vpThetaUVector(axis == 0 ? angle : 0., axis == 1 ? angle : 0., axis == 2 ? angle : 0.)) *
            cMb.getRotationMatrix());
    const vpHomogeneousMatrix cMo = turned * oMb.inverse();
    if (m_symmetries.hides(cMo, expected, m_looks.model())) {
      continue;
    }
    if (m_attempts.attempt(frame, {cMo, vpStart::BY_COLORS, expected})) {
      return;
    }
  }
}

END_VISP_NAMESPACE
