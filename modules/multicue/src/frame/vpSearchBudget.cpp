// SPDX-License-Identifier: GPL-2.0-or-later
#include "frame/vpSearchBudget.h"

#include <visp3/core/vpException.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
const double firstNumber = 500.;
const double leastNumber = 100.;
const double longest = 10000.; // Milliseconds.
// Of the time that is left when a search begins: its best poses have to be estimated, too.
const double shareOfSearch = 0.5;
} // namespace

void vpSearchBudget::set(double milliseconds)
{
  if (!(milliseconds >= 0. && milliseconds <= longest)) {
    throw vpException(vpException::badValue, "The search budget is %g ms: give 0 (no limit) to %g", milliseconds,
                      longest);
  }
  m_milliseconds = milliseconds;
  m_number = firstNumber;
}

std::size_t vpSearchBudget::number(std::size_t most) const
{
  return isLimited() ? std::min(static_cast<std::size_t>(m_number), most) : most;
}

void vpSearchBudget::learn(std::size_t number, double begin, double duration)
{
  const double allowed = shareOfSearch * std::max(m_milliseconds - begin, 0.);
  const double change = duration > 0. ? std::min(std::max(allowed / duration, 0.5), 2.) : 1.;
  m_number = std::max(change * static_cast<double>(number), leastNumber);
}

END_VISP_NAMESPACE
