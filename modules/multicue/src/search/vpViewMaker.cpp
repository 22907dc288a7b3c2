// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpViewMaker.h"

#include <exception>

#ifdef __linux__
#include <sys/resource.h>
#endif

BEGIN_VISP_NAMESPACE

namespace {
// Frames come first where there is one core for both. Elsewhere threads have no priority of their own by these means.
void giveWay()
{
#ifdef __linux__
  const int lowest = 19;
  setpriority(PRIO_PROCESS, 0, lowest); // On Linux, of this thread alone. Where it fails nothing is lost but time.
#endif
}
} // namespace

vpViewMaker::vpViewMaker(vpViewSphere &sphere) : m_sphere(sphere), m_thread([this] { make(); })
{
}

vpViewMaker::~vpViewMaker()
{
  m_mustStop = true;
  m_thread.join();
}

unsigned int vpViewMaker::level() const
{
  unsigned int level = m_sphere.options().level;
  while (level > 0 && !has(level)) {
    --level;
  }
  return level;
}

// The directions of coarse levels come first. Where memory runs out, searches go on with the views that there are.
void vpViewMaker::make() noexcept
{
  giveWay();
  try {
    for (std::size_t i = 0; i < m_sphere.size() && !m_mustStop; ++i) {
      m_sphere.make(i);
      m_made.store(i + 1, std::memory_order_release);
    }
  } catch (const std::exception &) { // Nobody could be told, and nothing but the finer views is missing.
  }
}

END_VISP_NAMESPACE
