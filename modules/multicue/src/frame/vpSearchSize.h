// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSearchSize_h
#define vpSearchSize_h

#include "frame/vpFrameDeadline.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

//! How much of all its poses a search draws, so that it ends in the time that it is given: it follows what the last
//! ones took. All of them without a deadline.
class vpSearchSize
{
public:
  //! A search begins. \param share Of what is left of the frame that it may take.
  void begin(const vpFrameDeadline &deadline, double share)
  {
    m_isLimited = deadline.isLimited();
    m_limit = deadline.after(share);
    m_allowed = share * deadline.left();
    m_begin = deadline.elapsed();
  }
  double share() const { return m_isLimited ? m_share : 1.; }
  std::size_t of(double number) const { return static_cast<std::size_t>(share() * number); }
  //! The moment at which it has to be over.
  const vpTimeLimit &limit() const { return m_limit; }
  //! It is over.
  void end(const vpFrameDeadline &deadline)
  {
    if (m_isLimited) {
      learn(m_allowed, deadline.elapsed() - m_begin);
    }
  }
  //! It took so long and was allowed to take so long, milliseconds.
  void learn(double allowed, double duration)
  {
    const double change = allowed / std::max(duration, 0.01);
    m_share = std::min(std::max(m_share * std::min(std::max(change, 0.5), 2.), leastShare), 1.);
  }

private:
  static constexpr double leastShare = 0.04; // Of fewer draws none comes near the right pose.
  double m_share = 0.25;                     // About 10 ms of one core, everywhere.
  bool m_isLimited = false;
  vpTimeLimit m_limit;
  double m_allowed = 0.;
  double m_begin = 0.;
};

END_VISP_NAMESPACE
#endif
