// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpHintedStarts_h
#define vpHintedStarts_h

#include "search/vpImageScore.h"
#include "starts/vpRoughStart.h"
#include "starts/vpStartCapture.h"

#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

//! What a program tells of where the object may be: its detector, and single hints.
class vpHintedStarts
{
public:
  //! By how much a hint has to be better than the pose that is tracked, in shares of what trusted poses had.
  static constexpr double leastGain = 0.05;
  //! The same as a logarithm of odds.
  static constexpr double leastOdds = 0.5;

  vpHintedStarts(const vpModelLooks &looks, vpImageScore &score, vpStartCapture &capture, vpRoughStart &rough)
      : m_looks(looks), m_score(score), m_capture(capture), m_rough(rough)
  {
  }

  //! Poses that are known to be wrong are passed over, and what the program throws stays inside.
  void askDetector(const vpCueFrame &image);
  void forgetDetected();
  //! The hint, and the likeliest poses about it by what was learnt; it is used up.
  std::vector<vpHomogeneousMatrix> take(const vpFrameContext &frame);

private:
  void takeDetected(const std::vector<vpWeightedPose> &poses);

  const vpModelLooks &m_looks;
  vpImageScore &m_score;
  vpStartCapture &m_capture;
  vpRoughStart &m_rough;
};

END_VISP_NAMESPACE
#endif
