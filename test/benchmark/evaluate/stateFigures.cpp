// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/stateFigures.h"

#include "evaluate/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {

namespace {
// Frames on end that speak for a change, as for losses.
const int enough = 5;

double share(std::size_t part, std::size_t whole)
{
  return whole == 0 ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(part) / static_cast<double>(whole);
}

bool endsWith(const std::string &text, const std::string &end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Goes through the frames of a run and notes when the object was away from the tracker.
class RecoveryFinder
{
public:
  explicit RecoveryFinder(const std::vector<FrameRecord> &records) : m_records(records) {}

  std::vector<Recovery> find()
  {
    for (std::size_t i = 0; i < m_records.size(); ++i) {
      if (!m_records[i].counted) {
        hide(i);
      } else {
        show(i);
      }
    }
    finish(m_records.size());
    return m_found;
  }

private:
  void hide(std::size_t i)
  {
    finish(i);
    m_away = true;
    m_current = {-1, -1, true};
    m_length = 0;
  }

  void show(std::size_t i)
  {
    if (m_away && m_current.frame < 0) {
      begin(i);
    }
    if (m_records[i].right != m_away) {
      m_length = 0; // Nothing changes.
      return;
    }
    m_run = m_length == 0 ? i : m_run;
    if (++m_length < enough) {
      return;
    }
    m_length = 0;
    if (m_away) {
      m_current.frames = static_cast<int>(m_run - m_begin);
      m_found.push_back(m_current);
    } else {
      m_current = Recovery();
      begin(m_run);
    }
    m_away = !m_away;
  }

  void begin(std::size_t i)
  {
    m_begin = i;
    m_current.frame = m_records[i].frame;
  }

  // It was not found until this frame.
  void finish(std::size_t end)
  {
    const bool isDecided = m_length == 0 && end - m_begin >= static_cast<std::size_t>(enough);
    if (m_away && m_current.frame >= 0 && isDecided) {
      m_found.push_back(m_current);
    }
  }

  const std::vector<FrameRecord> &m_records;
  std::vector<Recovery> m_found;
  Recovery m_current;
  bool m_away = false;
  std::size_t m_begin = 0; // Of m_current.
  std::size_t m_run = 0;   // First of the frames on end that speak for a change.
  int m_length = 0;        // Their number.
};
} // namespace

std::vector<Recovery> findRecoveries(const std::vector<FrameRecord> &records)
{
  return RecoveryFinder(records).find();
}

void StatePool::Frames::add(const FrameRecord &record)
{
  ++count;
  falseTracking += !record.right && record.answer.state == vpTrackingState::TRACKING ? 1 : 0;
  if (std::isfinite(record.answer.score)) {
    poses.push_back({record.answer.score, record.right});
  }
}

StateFigures::Frames StatePool::Frames::figures() const
{
  StateFigures::Frames result;
  result.count = count;
  result.falseTracking = share(falseTracking, count);
  result.rocArea = rocArea(poses);
  result.calibrationError = calibrationError(reliability(poses));
  return result;
}

void StatePool::add(const std::string &scene, Protocol protocol, const std::vector<FrameRecord> &records)
{
  for (const FrameRecord &record : records) {
    if (record.known) {
      m_known.add(record);
    }
    if (record.counted) {
      m_counted.add(record);
      m_lostWhileRight += record.right && record.answer.state == vpTrackingState::LOST ? 1 : 0;
    }
  }
  if (protocol != Protocol::RUN) {
    return; // The tracker was helped back.
  }
  const std::vector<Recovery> recoveries = findRecoveries(records);
  m_recoveries.insert(m_recoveries.end(), recoveries.begin(), recoveries.end());
  if (endsWith(scene, "_occlusion")) {
    ++m_occlusions;
    m_held += findLosses(records).empty() ? 1U : 0U;
  }
}

StateFigures StatePool::figures() const
{
  StateFigures result;
  result.counted = m_counted.figures();
  result.known = m_known.figures();
  result.lostWhileRight = share(m_lostWhileRight, m_counted.count);
  result.bins = reliability(m_counted.poses);
  result.roc = rocCurve(m_counted.poses);
  std::vector<double> frames;
  std::size_t soon = 0;
  for (const Recovery &recovery : m_recoveries) {
    if (recovery.frames >= 0) {
      frames.push_back(recovery.frames);
      soon += recovery.frames <= soonFrames ? 1 : 0;
    }
  }
  result.recoveries = m_recoveries.size();
  result.recovered = share(frames.size(), m_recoveries.size());
  result.recoveredSoon = share(soon, m_recoveries.size());
  result.recoveryFrames = quantile(frames, 0.5);
  result.occlusions = m_occlusions;
  result.heldThroughout = share(m_held, m_occlusions);
  return result;
}

} // namespace bench
