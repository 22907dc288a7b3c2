// SPDX-License-Identifier: GPL-2.0-or-later
#include "soak/soakReport.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace bench {
namespace {
const double mostGrowth = 1.; // Megabytes per 10,000 frames.
// Caches and the allocator's own memory fill up in the beginning: what comes after this share of the lines is compared.
const double settled = 0.4;

double residentMegabytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0.;
    if (word == "VmRSS:" && status >> kilobytes) {
      return kilobytes / 1024.;
    }
  }
  return 0.;
}

int openFiles()
{
  std::error_code error;
  const std::filesystem::directory_iterator files("/proc/self/fd", error);
  return error ? 0 : static_cast<int>(std::distance(begin(files), end(files)));
}
} // namespace

void SoakReport::add(int frame, const SoakCounts &counts)
{
  m_lines.push_back({frame, residentMegabytes(), openFiles(), counts});
}

std::string SoakReport::lastLine() const
{
  const Line &line = m_lines.back();
  char text[200];
  std::snprintf(
      text, sizeof(text),
      "%7d frames: %.1f MB resident, %d open files, %.2f ms of a processor per frame, %.0f %% TRACKING, %d new "
      "trackers, %d calls refused",
      line.frame, line.megabytes, line.files, 1000. * line.counts.seconds / std::max(line.counts.frames, 1),
      100. * line.counts.tracking / std::max(line.counts.frames, 1), line.counts.trackers, line.counts.refused);
  return text;
}

// Slope of the straight line through what was measured, by least squares.
double SoakReport::megabytesPer10000() const
{
  const std::size_t first = static_cast<std::size_t>(settled * static_cast<double>(m_lines.size()));
  const double count = static_cast<double>(m_lines.size() - first);
  double meanFrame = 0.;
  double meanMemory = 0.;
  for (std::size_t i = first; i < m_lines.size(); ++i) {
    meanFrame += m_lines[i].frame / count;
    meanMemory += m_lines[i].megabytes / count;
  }
  double product = 0.;
  double square = 0.;
  for (std::size_t i = first; i < m_lines.size(); ++i) {
    product += (m_lines[i].frame - meanFrame) * (m_lines[i].megabytes - meanMemory);
    square += (m_lines[i].frame - meanFrame) * (m_lines[i].frame - meanFrame);
  }
  return square > 0. ? 10000. * product / square : 0.;
}

int SoakReport::filesMore() const
{
  const std::size_t first = static_cast<std::size_t>(settled * static_cast<double>(m_lines.size()));
  return m_lines.empty() ? 0 : m_lines.back().files - m_lines[first].files;
}

std::string SoakReport::growth() const
{
  char text[120];
  std::snprintf(text, sizeof(text), "%+.2f MB per 10,000 frames after the first 40 %%, %+d open files",
                megabytesPer10000(), filesMore());
  return text;
}

bool SoakReport::grows() const
{
  return megabytesPer10000() > mostGrowth || filesMore() > 0;
}

} // namespace bench
