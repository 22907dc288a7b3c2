// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/trackingLog.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace programs {
namespace {
std::unique_ptr<vpWholeFile> open(const std::string &file)
{
  return file.empty() ? nullptr : std::make_unique<vpWholeFile>(file);
}

// The value that this share of the values does not exceed.
double quantile(std::vector<double> values, double share)
{
  std::sort(values.begin(), values.end());
  const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  return values[index];
}
} // namespace

TrackingLog::TrackingLog(const std::string &posesFile, const std::string &summaryFile)
    : m_poses(open(posesFile)), m_summary(open(summaryFile))
{
  if (m_poses) {
    m_poses->stream() << "frame,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23,ms,state,score\n"
                      << std::setprecision(9);
  }
}

void TrackingLog::add(const TrackedFrame &frame)
{
  m_milliseconds.push_back(frame.milliseconds);
  m_states[frame.state]++;
  if (!m_poses) {
    return;
  }
  std::ostream &poses = m_poses->stream();
  poses << frame.number << ",";
  for (unsigned int i = 0; i < 3; i++) {
    for (unsigned int j = 0; j < 4; j++) {
      poses << frame.cMo[i][j] << ",";
    }
  }
  poses << frame.milliseconds << "," << toString(frame.state) << "," << frame.score << "\n";
}

std::string TrackingLog::summary() const
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "frames: " << m_milliseconds.size() << "\n";
  if (!m_milliseconds.empty()) {
    text << "time, median: " << quantile(m_milliseconds, 0.5) << " ms\n"
         << "time, 95 %: " << quantile(m_milliseconds, 0.95) << " ms\n";
  }
  for (const auto state : {vpTrackingState::TRACKING, vpTrackingState::UNCERTAIN, vpTrackingState::LOST}) {
    const auto count = m_states.find(state);
    text << toString(state) << ": " << (count == m_states.end() ? 0 : count->second) << " frames\n";
  }
  if (!m_projectionErrors.empty()) {
    text << "projection error, median: " << quantile(m_projectionErrors, 0.5) << " degrees\n"
         << "projection error, maximum: " << quantile(m_projectionErrors, 1.) << " degrees\n";
  }
  return text.str();
}

void TrackingLog::finish()
{
  if (m_poses) {
    m_poses->close();
  }
  if (m_summary) {
    m_summary->stream() << summary();
    m_summary->close();
  }
}

} // namespace programs
