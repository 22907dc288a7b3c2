// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpStopwatch_h
#define vpStopwatch_h

#include <visp3/se3/vpCompatibility.h>

#include <chrono>

BEGIN_VISP_NAMESPACE

//! Adds the time of its life to a sum, in milliseconds; two readings of the clock, about 50 ns.
class vpStopwatch
{
public:
  explicit vpStopwatch(double &sum) : m_sum(sum), m_begin(Clock::now()) {}
  ~vpStopwatch() { m_sum += std::chrono::duration<double, std::milli>(Clock::now() - m_begin).count(); }
  vpStopwatch(const vpStopwatch &) = delete;
  vpStopwatch &operator=(const vpStopwatch &) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double &m_sum;
  Clock::time_point m_begin;
};

END_VISP_NAMESPACE
#endif
