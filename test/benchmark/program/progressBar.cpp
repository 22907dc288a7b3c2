// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/progressBar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace bench {

namespace {
const std::size_t columns = 40;
const auto interval = std::chrono::milliseconds(100);
} // namespace

ProgressBar::ProgressBar(std::size_t total)
    : m_total(total), m_shown(::isatty(STDERR_FILENO) == 1), m_begin(std::chrono::steady_clock::now())
{
}

ProgressBar::~ProgressBar()
{
  if (m_shown) {
    std::fprintf(stderr, "\r\033[K");
  }
}

void ProgressBar::setText(const std::string &text)
{
  m_text = text;
  draw();
}

void ProgressBar::advance(std::size_t count)
{
  m_done = std::min(m_done + count, m_total);
  const auto now = std::chrono::steady_clock::now();
  if (now - m_drawn > interval) {
    m_drawn = now;
    draw();
  }
}

void ProgressBar::draw() const
{
  if (!m_shown || m_total == 0) {
    return;
  }
  const double share = static_cast<double>(m_done) / static_cast<double>(m_total);
  const std::size_t filled = static_cast<std::size_t>(share * static_cast<double>(columns));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
  const std::string left =
      m_done == 0 ? "" : ", " + std::to_string(static_cast<int>(seconds * (1. - share) / share)) + " s left";
  std::fprintf(stderr, "\r\033[K[%s%s] %3.0f %%%s  %s", std::string(filled, '#').c_str(),
               std::string(columns - filled, '.').c_str(), 100. * share, left.c_str(), m_text.c_str());
  std::fflush(stderr);
}

} // namespace bench
