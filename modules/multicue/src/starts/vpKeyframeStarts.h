// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpKeyframeStarts_h
#define vpKeyframeStarts_h

#include "starts/vpAttempts.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

//! Starts from what is seen again of views that were trusted.
class vpKeyframeStarts
{
public:
  vpKeyframeStarts(const vpModelLooks &looks, const vpObjectMotion &motion, vpObjectKnowledge &knowledge,
                   vpAttempts &attempts)
      : m_looks(looks), m_motion(motion), m_knowledge(knowledge), m_attempts(attempts)
  {
  }

  //! \param isNear Around the expected pose, else in all of the image. \return True where one is enough.
  bool search(const vpFrameContext &frame, bool isNear)
  {
    if (frame.deadline.putsOff(vpPutOff::KEYFRAMES)) {
      return false;
    }
    vpKeyframes::Where where;
    where.expected = m_motion.expected();
    vpImageRegion region(0, 0, static_cast<int>(frame.image.width()), static_cast<int>(frame.image.height()));
    if (isNear) {
      region = m_looks.regionAround(where.expected);
      where.shift = nearShift;
      where.turn = nearTurn;
    }
    const std::vector<vpKeyframePose> found = find(frame, region, where);
    for (const vpKeyframePose &pose : found) {
      m_knowledge.mostAgreeing = std::max(m_knowledge.mostAgreeing, pose.agreeing);
    }
    m_attempts.learnKeyframes();
    return std::any_of(found.begin(), found.end(), [&](const vpKeyframePose &pose) {
      return m_attempts.attempt(frame, {pose.cMo, vpStart::FINE});
    });
  }

private:
  std::vector<vpKeyframePose> find(const vpFrameContext &frame, const vpImageRegion &region,
                                   const vpKeyframes::Where &where)
  {
    const vpTimedWork work(frame.deadline, vpPutOff::KEYFRAMES);
    return m_knowledge.keyframes.find(frame.image, region, where);
  }

  static constexpr double nearShift = 0.5; // Diameters.
  static constexpr double nearTurn = 1.;   // Radians.

  const vpModelLooks &m_looks;
  const vpObjectMotion &m_motion;
  vpObjectKnowledge &m_knowledge;
  vpAttempts &m_attempts;
};

END_VISP_NAMESPACE
#endif
