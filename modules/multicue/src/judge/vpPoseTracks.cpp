// SPDX-License-Identifier: GPL-2.0-or-later
#include "judge/vpPoseTracks.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t mostTracks = 3;
// What the frames before count beside one more: those on end are alike.
const double keptOdds = 0.5;
const double rightAtFirst = 0.3; // Of a pose that a search found.
// Logarithms of odds, as all that follow:
const double contestedMargin = 0.4; // Of 0.05 in shares, where both explain all.
const double leastValue = -5.;      // Below it a track ends.
const double leastLead = 2.;
const unsigned int framesToCompare = 4; // A track of fewer may be better than it seems.
const double leastOdds = -4.;           // Of one that is ahead.

// By a search.
vpPoseTracks::Track found(const vpHomogeneousMatrix &cMo)
{
  vpPoseTracks::Track track;
  track.cMo = track.before = cMo;
  track.belief.start(rightAtFirst);
  return track;
}

// What its odds come to where the frames to come say of it what this one does: that a pose was found later than others
// is no reason to drop it, nor that its first frames were worse, before it settled.
double promiseOf(const vpPoseTracks::Track &track)
{
  const double later = track.value > 0. ? track.value / (1. - keptOdds) : track.value;
  return std::max(track.odds, later) - track.change;
}

// With what one more frame says.
double oddsWith(const vpPoseTracks::Track &track, double value)
{
  return std::max(keptOdds * track.odds, 0.) + value;
}
} // namespace

void vpPoseTracks::clear()
{
  m_tracks.clear();
  m_followed = none;
  m_hasSearched = m_hasOthers = false;
  m_lead = 0.;
}

void vpPoseTracks::begin(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &before, const vpPoseBelief &belief)
{
  clear();
  Track track;
  track.cMo = cMo;
  track.before = before;
  track.odds = belief.odds();
  track.belief = belief;
  m_tracks.push_back(track);
}

std::size_t vpPoseTracks::indexOf(const vpHomogeneousMatrix &cMo, const Same &isSame) const
{
  const auto found =
      std::find_if(m_tracks.begin(), m_tracks.end(), [&](const Track &track) { return isSame(track.cMo, cMo); });
  return found == m_tracks.end() ? none : static_cast<std::size_t>(found - m_tracks.begin());
}

double vpPoseTracks::add(const vpHomogeneousMatrix &cMo, double explained, double value, double change,
                         const Same &isSame, const vpContourEvidence &contours)
{
  std::size_t index = m_followed != none ? m_followed : indexOf(cMo, isSame);
  if (index == none) {
    index = m_tracks.size();
    m_tracks.push_back(found(cMo));
  }
  Track &track = m_tracks[index];
  const double lesser = isSame(track.cMo, cMo) ? std::min(track.change, change) : change; // Else it jumped.
  if (!track.isSeen) {
    track.before = track.cMo;
  }
  if (!track.isSeen || value - lesser > track.now()) {
    track.cMo = cMo;
    track.explained = explained;
    track.value = value;
    track.change = lesser;
    track.contours = contours;
    track.isSeen = true;
  }
  return oddsWith(track, value) - lesser;
}

double vpPoseTracks::followedValue() const
{
  const bool isSeen = m_followed < m_tracks.size() && m_tracks[m_followed].isSeen;
  return isSeen ? m_tracks[m_followed].now() : -HUGE_VAL;
}

// What each track explains in this frame is told to it.
void vpPoseTracks::endFrame()
{
  m_followed = none;
  const auto ends = [](const Track &track) { return !track.isSeen || track.now() < leastValue; };
  m_tracks.erase(std::remove_if(m_tracks.begin(), m_tracks.end(), ends), m_tracks.end());
  for (Track &track : m_tracks) {
    track.odds = oddsWith(track, track.value);
    ++track.frames;
    track.isSeen = false;
  }
  std::stable_sort(m_tracks.begin(), m_tracks.end(),
                   [](const Track &a, const Track &b) { return promiseOf(a) > promiseOf(b); });
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
    other.belief.update(0., other.explained);
    other.confirmations = other.explained < confirming ? 0 : other.confirmations + 1;
    other.ahead = 0;
  }
  Track &first = m_tracks.front();
  const bool isCompared = first.compared > 0 || (m_hasOthers && seen != Seen::LITTLE);
  first.compared = isCompared ? first.compared + 1 : 0;
  m_lead = seen == Seen::WELL && m_hasSearched && m_tracks.size() > 1 ? first.standing() - m_tracks[1].standing() : 0.;
  m_hasSearched = m_hasOthers = false;
  first.ahead = m_lead > leastLead && first.standing() > leastOdds ? first.ahead + 1 : 0;
}

bool vpPoseTracks::isCompared() const
{
  if (m_tracks.empty() || m_tracks.front().compared < framesToCompare) {
    return false;
  }
  return std::none_of(m_tracks.begin() + 1, m_tracks.end(), [this](const Track &other) {
    return other.frames < framesToCompare && promiseOf(other) > m_tracks.front().standing() - contestedMargin;
  });
}

bool vpPoseTracks::isContested() const
{
  if (m_tracks.size() < 2 || m_tracks[1].frames < 2) {
    return false;
  }
  return promiseOf(m_tracks[1]) > m_tracks.front().standing() - contestedMargin;
}

END_VISP_NAMESPACE
