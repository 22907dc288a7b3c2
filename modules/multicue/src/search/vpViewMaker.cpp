// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpViewMaker.h"

#include <exception>
#include <filesystem>
#include <system_error>

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

// A system may refuse another thread; then the frame that begins waits for the views.
vpViewMaker::vpViewMaker(vpViewSphere &sphere, const std::string &folder) : m_sphere(sphere), m_folder(folder)
{
  try {
    m_thread = std::thread([this] {
      giveWay();
      run();
    });
  } catch (const std::system_error &) {
    run();
  }
}

vpViewMaker::~vpViewMaker()
{
  m_mustStop = true;
  if (m_thread.joinable()) {
    m_thread.join();
  }
}

unsigned int vpViewMaker::level() const
{
  unsigned int level = m_sphere.options().level;
  while (level > 0 && !has(level)) {
    --level;
  }
  return level;
}

// Where memory runs out or the disk is full nobody could be told, and nothing is missing but finer views, or a file
// that would have saved time.
void vpViewMaker::run() noexcept
{
  try {
    make();
  } catch (const std::exception &) {
  }
}

// The directions of coarse levels come first.
void vpViewMaker::make()
{
  bool isNew = false;
  for (std::size_t i = 0; i < m_sphere.size() && !m_mustStop; ++i) {
    isNew = isNew || !m_sphere.isMade(i);
    m_sphere.make(i);
    m_made.store(i + 1, std::memory_order_release);
  }
  if (isNew && !m_folder.empty() && !m_mustStop) {
    m_sphere.save((std::filesystem::path(m_folder) / m_sphere.fileName()).string());
  }
}

END_VISP_NAMESPACE
