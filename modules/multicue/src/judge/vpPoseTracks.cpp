// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpPoseTracks.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t mostTracks = 3;
const double doubtOfOne = 0.4; // Of a pose that was seen in one frame.
const double mostFrames = 6.;
const double framesOfBelieved = 4.; // That a pose is worth which is believed for certain.
const double rightAtFirst = 0.3;    // Of a pose that a search found.
const double contestedMargin = 0.05;
const double leastValue = 0.3; // Below it a track ends.
const double leastLead = 0.1;
const unsigned int framesToCompare = 4; // A track of fewer may be better than its mean, by as much:
const double youngMargin = 0.1;
const double leastMean = 0.55; // Of one that is ahead.

double standing(double mean, double frames)
{
  return mean - doubtOfOne / std::sqrt(frames);
}

// By a search.
vpPoseTracks::Track found(const vpHomogeneousMatrix &cMo)
{
  vpPoseTracks::Track track;
  track.cMo = track.before = cMo;
  track.belief.start(rightAtFirst);
  return track;
}

double grown(double frames)
{
  return std::min(frames + 1., mostFrames);
}

// With what it explains in one more frame.
double meanWith(const vpPoseTracks::Track &track, double value)
{
  return track.mean + (value - track.mean) / grown(track.frames);
}
} // namespace

void vpPoseTracks::clear()
{
  m_tracks.clear();
  m_followed = none;
  m_hasSearched = m_hasOthers = false;
  m_lead = 0.;
}

void vpPoseTracks::begin(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &before, double explained,
                         const vpPoseBelief &belief)
{
  clear();
  Track track;
  track.cMo = cMo;
  track.before = before;
  track.mean = explained;
  track.frames = framesOfBelieved * belief.probability();
  track.belief = belief;
  m_tracks.push_back(track);
}

std::size_t vpPoseTracks::indexOf(const vpHomogeneousMatrix &cMo, const Same &isSame) const
{
  const auto found =
      std::find_if(m_tracks.begin(), m_tracks.end(), [&](const Track &track) { return isSame(track.cMo, cMo); });
  return found == m_tracks.end() ? none : static_cast<std::size_t>(found - m_tracks.begin());
}

double vpPoseTracks::add(const vpHomogeneousMatrix &cMo, double value, double change, const Same &isSame,
                         const vpContourEvidence &contours)
{
  std::size_t index = m_followed != none ? m_followed : indexOf(cMo, isSame);
  if (index == none) {
    index = m_tracks.size();
    m_tracks.push_back(found(cMo));
  }
  Track &track = m_tracks[index];
  const double lesser = isSame(track.cMo, cMo) ? std::min(track.change, change) : change; // Else it jumped.
  value -= lesser;
  if (!track.isSeen) {
    track.before = track.cMo;
  }
  if (!track.isSeen || value > track.value) {
    track.cMo = cMo;
    track.value = value;
    track.change = lesser;
    track.contours = contours;
    track.isSeen = true;
  }
  return standing(meanWith(track, value), grown(track.frames));
}

double vpPoseTracks::followedValue() const
{
  return m_followed < m_tracks.size() && m_tracks[m_followed].isSeen ? m_tracks[m_followed].value : -HUGE_VAL;
}

// What each track explains in this frame is told to it.
void vpPoseTracks::endFrame()
{
  m_followed = none;
  const auto ends = [](const Track &track) { return !track.isSeen || track.value < leastValue; };
  m_tracks.erase(std::remove_if(m_tracks.begin(), m_tracks.end(), ends), m_tracks.end());
  for (Track &track : m_tracks) {
    track.mean = meanWith(track, track.value);
    track.frames = grown(track.frames);
    track.isSeen = false;
  }
  std::stable_sort(m_tracks.begin(), m_tracks.end(), [](const Track &a, const Track &b) {
    return standing(a.mean, a.frames) > standing(b.mean, b.frames);
  });
}

void vpPoseTracks::dropDoubles(const Same &isSame)
{
  std::vector<Track> kept;
  for (const Track &track : m_tracks) {
    const auto isDouble = [&](const Track &before) { return isSame(before.cMo, track.cMo); };
    if (kept.size() < mostTracks && std::none_of(kept.begin(), kept.end(), isDouble)) {
      kept.push_back(track);
    }
  }
  m_tracks = std::move(kept);
}

// What only one of two poses has tells them apart, whatever they have in common.
void vpPoseTracks::compareContours()
{
  const vpContourEvidence &first = m_tracks.front().contours;
  const auto isBeaten = [&first](Track &other) {
    other.behind += vpContourEvidence::oddsOf(first.advantageOver(other.contours));
    return other.behind >= vpContourEvidence::decisiveOdds;
  };
  m_tracks.erase(std::remove_if(m_tracks.begin() + 1, m_tracks.end(), isBeaten), m_tracks.end());
}

void vpPoseTracks::choose(const vpHomogeneousMatrix &cMo, Seen seen, const Same &isSame)
{
  endFrame();
  const auto best =
      std::find_if(m_tracks.begin(), m_tracks.end(), [&](const Track &track) { return isSame(track.cMo, cMo); });
  if (best == m_tracks.end()) {
    m_tracks.insert(m_tracks.begin(), found(cMo));
  } else {
    std::rotate(m_tracks.begin(), best, best + 1);
  }
  dropDoubles(isSame);
  compareContours();
  for (std::size_t i = 1; i < m_tracks.size(); ++i) {
    Track &other = m_tracks[i];
    other.belief.update(0., other.value);
    other.confirmations = other.value < confirming ? 0 : other.confirmations + 1;
    other.ahead = 0;
  }
  Track &first = m_tracks.front();
  const bool isCompared = first.compared > 0 || (m_hasOthers && seen != Seen::LITTLE);
  first.compared = isCompared ? first.compared + 1 : 0;
  m_lead = seen == Seen::WELL && m_hasSearched && m_tracks.size() > 1 ? first.mean - m_tracks[1].mean : 0.;
  m_hasSearched = m_hasOthers = false;
  first.ahead = m_lead > leastLead && first.mean > leastMean ? first.ahead + 1 : 0;
}

bool vpPoseTracks::isCompared() const
{
  if (m_tracks.empty() || m_tracks.front().compared < framesToCompare) {
    return false;
  }
  return std::none_of(m_tracks.begin() + 1, m_tracks.end(), [this](const Track &other) {
    return other.frames < framesToCompare && other.mean > m_tracks.front().mean - youngMargin;
  });
}

bool vpPoseTracks::isContested() const
{
  if (m_tracks.size() < 2 || !(m_tracks[1].frames > 1.)) {
    return false;
  }
  const Track &other = m_tracks[1]; // Its first frames may have been worse, before it settled.
  return std::max(other.mean, other.value) > m_tracks.front().mean - contestedMargin;
}

END_VISP_NAMESPACE
