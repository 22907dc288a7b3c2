// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/vpStartPlan.h"

#include "motion/vpEvenMotion.h"

BEGIN_VISP_NAMESPACE

namespace {
// Of the object in one frame, its shift in diameters plus its turn in radians: what moves less is found where it was,
// and a pose that jumped farther was corrected, which tells nothing of the next frame.
const double leastMoved = 0.01;
const double mostMoved = 0.4;
// Of a pose that is as likely where it was, a pose ahead may as well be its drift. Logarithm of odds.
const double valueToStay = -0.9;
} // namespace

void vpStartPlan::run(const vpFrameContext &frame)
{
  const bool isAfterLoss = m_situation.mustConfirm;
  const std::vector<vpPoseTracks::Track> &tracks = m_situation.tracks.tracks();
  const vpPoseTracks::Track first = tracks.empty() ? vpPoseTracks::Track() : tracks.front();
  bool isEnough = follow(frame, first);
  m_situation.tracks.followNone();
  if (isAfterLoss && followOthers(frame)) {
    isEnough = true;
  }
  if (m_rough.hasHint) {
    isEnough = tryHint(frame) || isEnough;
  }
  if (isEnough) {
    return;
  }
  if (isAfterLoss) {
    findAgain(frame);
  } else {
    tryOthers(frame);
  }
}

bool vpStartPlan::follow(const vpFrameContext &frame, const vpPoseTracks::Track &first)
{
  bool isEnough = m_attempts.attempt(
      frame, {m_motion.expected(), vpStart::COARSE_TO_FINE, std::nullopt, m_motion.holdsPrediction()});
  isEnough = followInert(frame) || isEnough;
  return isEnough || (m_situation.mustConfirm && followAhead(frame, first));
}

// Where the object is if it moves as it did some frames ago. \return True where that leads to a pose that is enough.
bool vpStartPlan::followInert(const vpFrameContext &frame)
{
  const vpInertia &inertia = m_motion.inertia;
  return m_attempts.hasBest() && inertia.isLeftBy(m_attempts.best().cMo) &&
         m_attempts.attempt(frame, {inertia.cMo(), vpStart::FINE, std::nullopt, m_motion.holdsPrediction()});
}

// After a loss nothing is known of the object's velocity but what the last two frames show. \return True where the pose
// that goes on as the track moved leads to one that is enough.
bool vpStartPlan::followAhead(const vpFrameContext &frame, const vpPoseTracks::Track &track)
{
  if (m_situation.tracks.followedValue() >= valueToStay) {
    return false;
  }
  const vpPoseTangent motion = vpPoseExponential::log(track.before.inverse() * track.cMo);
  const Eigen::Vector3d centre = m_looks.model().centre();
  const Eigen::Vector3d shift = motion.head<3>() + motion.tail<3>().cross(centre);
  const double moved = shift.norm() / m_looks.model().diameter() + motion.tail<3>().norm();
  return moved >= leastMoved && moved <= mostMoved &&
         m_attempts.attempt(frame, {vpEvenMotion(track.cMo, motion, centre, 1.), vpStart::FINE});
}

// After a loss: the other poses that may be right. \return True where one of them is better, and enough.
bool vpStartPlan::followOthers(const vpFrameContext &frame)
{
  vpPoseTracks &tracks = m_situation.tracks;
  const std::size_t number = tracks.tracks().size(); // Before this frame.
  bool isEnough = false;
  for (std::size_t i = 1; i < number; ++i) {
    const vpPoseTracks::Track track = tracks.tracks()[i]; // As it was before the attempts.
    tracks.follow(i);
    isEnough = m_attempts.attempt(frame, {track.cMo, vpStart::BY_COLORS}) || isEnough;
    isEnough = m_attempts.attempt(frame, {track.cMo, vpStart::FINE}) || isEnough;
    isEnough = followAhead(frame, track) || isEnough;
  }
  tracks.followNone();
  return isEnough;
}

// One more attempt, as likely beforehand as the expected pose. \return True where it was taken and explains enough.
bool vpStartPlan::tryHint(const vpFrameContext &frame)
{
  const vpHomogeneousMatrix expected = m_motion.expected();
  const vpAttempts::Attempt before = m_attempts.best();
  bool isEnough = false;
  for (const vpHomogeneousMatrix &start : m_hints.take(frame)) {
    m_motion.expect(start);
    isEnough = m_attempts.attempt(frame, {start, vpStart::BY_COLORS});
  }
  if (m_attempts.best().value > before.value + vpHintedStarts::leastOdds) {
    m_motion.expect(m_attempts.best().cMo); // That it moved so far is no surprise.
    m_motion.forget();
    return isEnough;
  }
  m_motion.expect(expected);
  m_attempts.setBest(before);
  return false;
}

bool vpStartPlan::tryKeyframes(const vpFrameContext &frame, bool isNear)
{
  return m_settings.searches && m_cues.uses(vpCueSet::POINT) && m_keyframes.search(frame, isNear);
}

// Starts elsewhere, where the image does not look as it should at the pose that was found.
void vpStartPlan::tryOthers(const vpFrameContext &frame)
{
  const vpHomogeneousMatrix expected = m_motion.expected();
  m_cues.edges().reset(); // A jump of the light changes all contrasts at once.
  // Colours mislead where much of the object looks like what is behind it, and in other light.
  if (m_attempts.attempt(frame, {expected, vpStart::AS_VIEWED})) {
    return;
  }
  // What costs least for what it finds comes first: the search finds most of what keyframes (5 to 11 ms) and edges
  // propose. Keyframes tell of jumps that turn the image, where colours do not help.
  if (m_settings.searches && (m_near.search(frame) || tryKeyframes(frame, true))) {
    return;
  }
  const bool isEnough = m_cues.uses(vpCueSet::EDGE) && attemptProposed(frame, expected);
  if (!isEnough && !m_settings.searches && m_attempts.best().explained < vpJudgedPose::badlyExplained) {
    m_near.turn(frame);
  }
}

// After a loss, where the pose of the frame before does not explain the image.
void vpStartPlan::findAgain(const vpFrameContext &frame)
{
  if (!m_outcome.isLost() && (followExpected(frame) || tryProposed(frame))) {
    return;
  }
  const Eigen::Vector3d centre = m_looks.model().centre();
  const auto tryMovedOn = [&](const vpObjectMotion::Trusted &from) {
    return m_attempts.attempt(frame, {m_motion.movedOn(from, 1., centre), vpStart::FINE});
  };
  if (tryMovedOn(m_motion.trusted) || (m_motion.trustedBefore && tryMovedOn(*m_motion.trustedBefore))) {
    return;
  }
  if (m_proof.hasFailed() && m_situation.framesSinceLoss == 1) {
    for (const vpHomogeneousMatrix &cMo : m_halfTurns.turned(m_motion.trusted.cMo)) {
      m_attempts.attempt(frame, {cMo, vpStart::FINE});
    }
  }
  if (!tryKeyframes(frame, false)) {
    m_everywhere.search(frame);
    m_everywhere.turnByHalf(frame);
    m_situation.tracks.noteOthers();
  }
}

// What hides the object misleads colours and points.
bool vpStartPlan::followExpected(const vpFrameContext &frame)
{
  m_situation.tracks.follow(0);
  const bool isEnough = m_attempts.attempt(frame, {m_motion.expected(), vpStart::AS_VIEWED});
  m_situation.tracks.followNone();
  return isEnough;
}

// The best pose of the frame may have settled on edges beside its own. Other cues have to tell which of those that the
// edges around allow is right. \return True where one is enough.
bool vpStartPlan::tryProposed(const vpFrameContext &frame)
{
  const bool isTold = m_cues.uses(vpCueSet::EDGE) && !m_cues.isEdgesAlone();
  if (!isTold || !m_attempts.hasBest()) {
    return false;
  }
  const vpHomogeneousMatrix best = m_attempts.best().cMo;
  m_situation.tracks.follow(best, m_alike.same());
  const bool isEnough = attemptProposed(frame, best);
  m_situation.tracks.followNone();
  return isEnough;
}

// The pose that the edges around one allow. \return True where it leads to one that is enough.
bool vpStartPlan::attemptProposed(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo)
{
  if (frame.deadline.putsOff(vpPutOff::STARTS)) {
    return false;
  }
  const vpHomogeneousMatrix proposed = m_edges.propose(frame, cMo);
  m_attempts.noteMoved();
  return m_attempts.attempt(frame, {proposed, vpStart::AS_VIEWED, cMo});
}

END_VISP_NAMESPACE
