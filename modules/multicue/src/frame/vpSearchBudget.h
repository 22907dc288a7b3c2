// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSearchBudget_h
#define vpSearchBudget_h

#include <visp3/se3/vpCompatibility.h>

#include <chrono>
#include <cstddef>

BEGIN_VISP_NAMESPACE

//! What a frame may look for within a time; without one, all that there is.
class vpSearchBudget
{
public:
  using Clock = std::chrono::steady_clock;

  //! \param milliseconds Of a frame; 0: no limit.
  void set(double milliseconds);
  double get() const { return m_milliseconds; }
  void startFrame() { m_begin = Clock::now(); }
  bool isLimited() const { return m_milliseconds > 0.; }
  //! True where nothing more is to be begun in this frame.
  bool isSpent() const { return isLimited() && elapsed() >= m_milliseconds; }
  //! Of the poses that a search is to look at. \param most Without a limit.
  std::size_t number(std::size_t most) const;
  //! A search with so many poses that began so many milliseconds after the frame took this time.
  void learn(std::size_t number, double begin, double duration);
  //! Since the frame began, milliseconds.
  double elapsed() const { return std::chrono::duration<double, std::milli>(Clock::now() - m_begin).count(); }

private:
  double m_milliseconds = 0.;
  double m_number = 0.;
  Clock::time_point m_begin;
};

END_VISP_NAMESPACE
#endif
