// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/vpNearSearch.h"

BEGIN_VISP_NAMESPACE

namespace {
// From the near spread and from a wider one each. Of three objects in a hand, three images apart (three sequences,
// protocol rbot), 96.4 % were followed with 80, 97.3 % with 160 and 98.2 % with 240.
const std::size_t nearNumber = 240;
const std::size_t scoredNumber = 400; // Where colours do not help.
// With 1.6, 56 % of the frames of five objects that move 40 px and 16 degrees from image to image were followed, with
// 2.5 it was 74 %.
const double widerFactor = 2.5;
const std::size_t modeNumber = 10; // Around each mode of the particles.
// Of what is left of a frame with a deadline: the best poses have to be estimated, too.
const double shareOfSearch = 0.4;
// Turns of the object that are tried, radians.
const double angleOfTurn = 0.35;
} // namespace

bool vpNearSearch::search(const vpFrameContext &frame)
{
  if (!m_score.setFrameInTime(frame)) {
    return false;
  }
  if (draw(frame, nearNumber, m_size, true)) {
    return true;
  }
  // Colours may lead away from the object, or there are none.
  return !frame.deadline.putsOff(vpPutOff::SEARCH) && draw(frame, scoredNumber, m_sizeByScore, false);
}

// \param number From each spread. \return True where one of the best poses is enough.
bool vpNearSearch::draw(const vpFrameContext &frame, std::size_t number, vpSearchSize &size, bool byColors)
{
  const vpHomogeneousMatrix &expected = m_motion.expected();
  const vpPoseSearch::Spread near = vpPoseSearch::near();
  size.begin(frame.deadline, shareOfSearch);
  const std::size_t drawn = size.of(static_cast<double>(number));
  vpPoseSearch search(m_score.score(), m_looks.model(), frame.streams.searches++);
  search.setLimit(size.limit());
  search.setSymmetries(m_symmetries.get());
  search.setPrior({expected}, near, vpPoseSearch::Tail::HEAVY);
  search.scatter({expected}, near, drawn);
  search.scatter({expected}, near.grown(widerFactor), drawn);
  if (byColors) { // What the frames before left open.
    const vpHomogeneousMatrix bMo = m_looks.centreFrame().inverse();
    for (const vpPoseMode &mode : m_particles.modes()) {
      search.scatter({mode.cMo * bMo}, vpPoseSearch::same(), modeNumber);
    }
  }
  search.mix();
  if (byColors) {
    m_score.settle(search, size.share());
  } else {
    m_score.settleByScore(search, size.share());
  }
  size.end(frame.deadline);
  if (search.isCutShort()) {
    frame.deadline.notePutOff(vpPutOff::SEARCH);
  }
  return m_attempts.attemptBest(frame, search, false); // They were aligned already.
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
