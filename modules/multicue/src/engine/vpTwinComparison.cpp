// SPDX-License-Identifier: GPL-2.0-or-later
#include "engine/vpTwinComparison.h"

#include "motion/vpTurnBetween.h"

#include <algorithm>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// What the images before count beside this one: those of a twin that differs in nothing tell less and less.
const double keptLead = 0.9;
// In each of so many others are looked for around the pose; poses drawn for that, and those that are compared.
const unsigned int searchInterval = 10;
const double searched = 80.;
const std::size_t mostFound = 4;
const double shareOfSearch = 0.5; // Of what is left of a frame with a deadline.
// A pose that slipped by less than this (radians) is turned back to; where its twin has less than these odds before it.
const double mostSlip = 0.5;
const double leastOdds = 2.;

// While twins are compared, edges have no memory: the contrasts that are remembered are those of the followed pose.
class EdgesWithoutMemory
{
public:
  EdgesWithoutMemory(vpEdgeCue &edges, vpEdgeCue &plain) : m_edges(edges), m_plain(plain)
  {
    std::swap(m_edges, m_plain);
    m_edges.setSettings(m_plain.settings());
    m_edges.reset();
  }
  ~EdgesWithoutMemory() { std::swap(m_edges, m_plain); }
  EdgesWithoutMemory(const EdgesWithoutMemory &) = delete;
  EdgesWithoutMemory &operator=(const EdgesWithoutMemory &) = delete;

private:
  vpEdgeCue &m_edges;
  vpEdgeCue &m_plain;
};
} // namespace

std::optional<vpHomogeneousMatrix> vpTwinComparison::compare(const vpFrameContext &frame,
                                                             const vpHomogeneousMatrix &followed, bool &hasMoved)
{
  if (++m_twins.frames % searchInterval == 0) {
    search(frame, followed);
  }
  if (frame.deadline.putsOff(vpPutOff::COMPARISON)) {
    return std::nullopt;
  }
  hasMoved = !m_twins.twins.empty();
  if (!hasMoved) {
    return std::nullopt;
  }
  const EdgesWithoutMemory plain(m_cues.edges(), m_plainEdges);
  weigh(frame, followed);
  return right(frame, followed);
}

// Brings the cues to a pose, and looks at its contours. \return Nothing where that fails.
std::optional<vpHomogeneousMatrix> vpTwinComparison::refine(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo,
                                                            vpContourEvidence &contours)
{
  const vpTimedWork work(frame.deadline, vpPutOff::COMPARISON);
  const vpEstimate estimate = m_estimator.from(frame, {cMo, vpStart::FINE});
  if (!estimate.isFound) {
    return std::nullopt;
  }
  m_edges.match(frame, estimate.cMo);
  contours.set(m_cues.edges(), estimate.cMo);
  return estimate.cMo;
}

// The pose may have slipped to contours beside its own, while little of the object was in the image.
void vpTwinComparison::search(const vpFrameContext &frame, const vpHomogeneousMatrix &followed)
{
  if (!m_score.setFrameInTime(frame)) {
    return;
  }
  m_size.begin(frame.deadline, shareOfSearch);
  vpPoseSearch search(m_score.score(), m_looks.model(), frame.streams.searches++);
  search.setSymmetries(m_symmetries.get());
  search.setPrior({followed}, vpPoseSearch::near(), vpPoseSearch::Tail::LIGHT);
  search.setLimit(m_size.limit());
  search.scatter({followed}, vpPoseSearch::near(), m_size.of(searched));
  m_score.settle(search, m_size.share());
  m_size.end(frame.deadline);
  search.keepBest(mostFound, vpPoseSearch::same());
  for (const vpPoseCandidate &candidate : search.candidates()) {
    m_twins.twins.push_back({followed.inverse() * m_alike.nearest(candidate.cMo), 0.});
  }
}

// Those that lost are forgotten, and those that lead to the same pose.
void vpTwinComparison::weigh(const vpFrameContext &frame, const vpHomogeneousMatrix &followed)
{
  m_edges.match(frame, followed);
  vpContourEvidence contours;
  contours.set(m_cues.edges(), followed);
  const double surface = m_proof.surfaceEvidence(followed, m_knowledge);
  std::vector<Twin> kept;
  for (Twin &twin : m_twins.twins) {
    if (frame.deadline.putsOff(vpPutOff::COMPARISON)) {
      kept.push_back(twin);
      continue;
    }
    vpContourEvidence others;
    const std::optional<vpHomogeneousMatrix> other = refine(frame, followed * twin.oMt, others);
    if (!other || m_alike.same()(*other, followed)) {
      continue;
    }
    twin.lead = keptLead * twin.lead + vpContourEvidence::oddsOf(contours.advantageOver(others)) + surface -
                m_proof.surfaceEvidence(*other, m_knowledge);
    twin.oMt = followed.inverse() * *other;
    if (twin.lead < vpContourEvidence::decisiveOdds) {
      kept.push_back(twin);
    }
  }
  m_twins.twins = std::move(kept);
}

// The one that won, if any. The pose that is followed may only have slipped: then the twin turned back shows as much.
std::optional<vpHomogeneousMatrix> vpTwinComparison::right(const vpFrameContext &frame,
                                                           const vpHomogeneousMatrix &followed)
{
  const auto best = std::min_element(m_twins.twins.begin(), m_twins.twins.end(),
                                     [](const Twin &a, const Twin &b) { return a.lead < b.lead; });
  if (best == m_twins.twins.end() || best->lead > -vpContourEvidence::decisiveOdds) {
    return std::nullopt;
  }
  vpContourEvidence won;
  const std::optional<vpHomogeneousMatrix> right = refine(frame, followed * best->oMt, won);
  if (!right) {
    return std::nullopt;
  }
  for (const vpHomogeneousMatrix &turned : m_halfTurns.turned(*right)) {
    vpContourEvidence contours;
    if (vpTurnBetween(turned, followed) < mostSlip) {
      const std::optional<vpHomogeneousMatrix> back = refine(frame, turned, contours);
      if (back && vpContourEvidence::oddsOf(won.advantageOver(contours)) < leastOdds) {
        return back;
      }
    }
  }
  return right;
}

END_VISP_NAMESPACE
