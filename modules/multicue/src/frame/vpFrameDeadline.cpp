// SPDX-License-Identifier: GPL-2.0-or-later
#include "frame/vpFrameDeadline.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
// Of the most that some work took, so much is left when it takes less: what was an exception is forgotten in some ten
// times.
const double keptMost = 0.9;
// Where the machine was busy elsewhere, work takes any time. Twice what it took before is believed at once.
const double mostGrowth = 2.;
// Kept free, milliseconds: what was begun in time takes so much longer than expected in one of a hundred frames.
const double margin = 1.5;
// After so many frames on end that put a search off, the next one may take so many times as long. With all cores of a
// machine taken six times over, an object that is hidden for a while was never found again without, in a demo of 150
// images.
const unsigned int mostHungry = 3;
const double feast = 4.;
} // namespace

const char *toString(vpPutOff work)
{
  constexpr std::array<const char *, 4> names = {"STARTS", "KEYFRAMES", "SEARCH", "COMPARISON"};
  return names.at(static_cast<std::size_t>(work));
}

void vpFrameDeadline::Duration::learn(double duration)
{
  const double believed = most > 0. ? std::min(duration, mostGrowth * most) : duration;
  most = std::max(believed, keptMost * most + (1. - keptMost) * believed);
}

void vpFrameDeadline::set(double milliseconds)
{
  if (!(milliseconds >= 0. && milliseconds <= longest)) {
    throw vpException(vpException::badValue, "The frame's deadline is %g ms: give 0 (none) to %g", milliseconds,
                      longest);
  }
  m_milliseconds = m_end = milliseconds;
}

void vpFrameDeadline::startFrame()
{
  m_begin = Clock::now();
  m_hungryFrames = m_isSearchPutOff ? m_hungryFrames + 1 : 0;
  m_isSearchPutOff = false;
  m_end = m_milliseconds;
  if (m_hungryFrames >= mostHungry) {
    m_end *= feast;
    m_hungryFrames = 0;
  }
  m_putOff.clear();
}

double vpFrameDeadline::left() const
{
  return isLimited() ? m_end - margin - m_ending.most - elapsed() : std::numeric_limits<double>::infinity();
}

bool vpFrameDeadline::putsOff(vpPutOff work)
{
  Duration &duration = durationOf(work);
  if (left() > duration.most) {
    return false;
  }
  duration.most *= keptMost; // It may be tried again some time.
  m_isSearchPutOff = m_isSearchPutOff || work == vpPutOff::SEARCH;
  notePutOff(work);
  return true;
}

void vpFrameDeadline::notePutOff(vpPutOff work)
{
  if (std::find(m_putOff.begin(), m_putOff.end(), work) == m_putOff.end()) {
    m_putOff.push_back(work);
  }
}

vpTimeLimit vpFrameDeadline::after(double share) const
{
  if (!isLimited()) {
    return vpTimeLimit();
  }
  const std::chrono::duration<double, std::milli> part(share * std::max(left(), 0.));
  return vpTimeLimit(Clock::now() + std::chrono::duration_cast<Clock::duration>(part));
}

END_VISP_NAMESPACE
