// SPDX-License-Identifier: GPL-2.0-or-later
#include "track/trackingLog.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace programs {
namespace {
void open(std::ofstream &stream, const std::string &option, const std::string &file)
{
  if (file.empty()) {
    return;
  }
  stream.open(file);
  if (!stream) {
    throw vpException(vpException::ioError, option + " " + file + " cannot be written: does the folder exist?");
  }
}

void close(std::ofstream &stream, const std::string &file)
{
  if (!file.empty() && !stream.flush()) {
    throw vpException(vpException::ioError, file + " could not be written to its end: is the disk full?");
  }
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
    : m_posesFile(posesFile), m_summaryFile(summaryFile)
{
  open(m_poses, "--poses", posesFile);
  open(m_summary, "--summary", summaryFile);
  m_poses << "frame,m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23,ms,state,score\n" << std::setprecision(9);
}

void TrackingLog::add(const TrackedFrame &frame)
{
  m_milliseconds.push_back(frame.milliseconds);
  m_states[frame.state]++;
  m_poses << frame.number << ",";
  for (unsigned int i = 0; i < 3; i++) {
    for (unsigned int j = 0; j < 4; j++) {
      m_poses << frame.cMo[i][j] << ",";
    }
  }
  m_poses << frame.milliseconds << "," << toString(frame.state) << "," << frame.score << "\n";
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
  m_summary << summary();
  close(m_poses, m_posesFile);
  close(m_summary, m_summaryFile);
}

} // namespace programs
