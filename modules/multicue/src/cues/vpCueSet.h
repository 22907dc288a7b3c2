// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCueSet_h
#define vpCueSet_h

#include "cues/vpTrackedColors.h"
#include "cues/vpTrackedEdges.h"
#include "cues/vpTrackedPoints.h"

#include <visp3/multicue/vpCueKind.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <map>
#include <vector>

BEGIN_VISP_NAMESPACE

//! A value for each kind of cue, in the order of vpCueKinds.
struct vpCueValues
{
  std::array<double, vpCueKinds::most> of{};

  double &operator[](int type) { return of[vpCueKinds::indexOf(type)]; }
  double operator[](int type) const { return of[vpCueKinds::indexOf(type)]; }
};

//! The cues of a tracker: those in use, in the order of vpCueKinds, and the settings of all.
class vpCueSet
{
public:
  static constexpr int EDGE = vpMbMultiCueTracker::EDGE_TRACKER;
  static constexpr int COLOR = vpMbMultiCueTracker::COLOR_TRACKER;
  static constexpr int POINT = vpMbMultiCueTracker::KLT_TRACKER;

  struct Used
  {
    const vpCueKind *kind;
    vpTrackedCue *cue;
  };

  vpCueSet();
  int type() const { return m_type; }
  //! \param type Sum of types of kinds. \throw vpException where a cue cannot be had; the cues before stay.
  void setType(int type, vpModelLooks &looks);
  bool uses(int type) const { return (m_type & type) != 0; }
  bool isEdgesAlone() const { return m_type == EDGE; }
  const std::vector<Used> &used() const { return m_used; }
  //! \param type Of a kind that is used.
  const Used &find(int type) const;

  vpEdgeCue &edges() { return m_edges->cue(); }
  const vpEdgeCue &edges() const { return m_edges->cue(); }
  vpTrackedEdges &edgePart() { return *m_edges; }
  vpColorCue &color() { return m_colors->cue(); }
  const vpColorCue &color() const { return m_colors->cue(); }
  vpTrackedColors &colorPart() { return *m_colors; }
  vpTrackedPoints &pointPart() { return *m_points; }
  const vpTrackedPoints &pointPart() const { return *m_points; }
  //! True where colours are used, and have coarse levels.
  bool hasCoarseColors() const { return uses(COLOR) && !color().settings().scales.empty(); }
  //! True where colours are used, and known.
  bool knowsColors() const { return uses(COLOR) && color().histograms().isKnown(); }

  //! A start: forgets all that images taught.
  void forget(vpModelLooks &looks);

  std::map<int, double> factors; //!< Of the cues' rows, by type; 1 for those that are not in it.

private:
  std::vector<Used> ofType(int type) const;

  int m_type = EDGE;
  std::vector<std::unique_ptr<vpTrackedCue>> m_cues; // Of all kinds.
  std::vector<Used> m_used;
  vpTrackedEdges *m_edges;
  vpTrackedColors *m_colors;
  vpTrackedPoints *m_points;
};

END_VISP_NAMESPACE
#endif
