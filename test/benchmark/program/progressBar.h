// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchProgressBar_h
#define benchProgressBar_h

#include <chrono>
#include <string>

namespace bench {

//! A line on the error stream that shows how far long work is; nothing where that is no terminal.
class ProgressBar
{
public:
  explicit ProgressBar(std::size_t total);
  ~ProgressBar();
  ProgressBar(const ProgressBar &) = delete;
  ProgressBar &operator=(const ProgressBar &) = delete;

  void setText(const std::string &text);
  void advance(std::size_t count);

private:
  void draw() const;

  std::size_t m_total;
  std::size_t m_done = 0;
  std::string m_text;
  bool m_shown;
  std::chrono::steady_clock::time_point m_begin;
  std::chrono::steady_clock::time_point m_drawn;
};

} // namespace bench
#endif
