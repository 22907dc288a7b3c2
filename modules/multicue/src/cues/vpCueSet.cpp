// SPDX-License-Identifier: GPL-2.0-or-later
#include "cues/vpCueSet.h"

#include <algorithm>

BEGIN_VISP_NAMESPACE

vpCueSet::vpCueSet()
{
  for (const vpCueKind &kind : vpCueKinds::all()) {
    m_cues.push_back(kind.make());
  }
  const auto part = [this](int type) { return m_cues[vpCueKinds::indexOf(type)].get(); };
  m_edges = static_cast<vpTrackedEdges *>(part(EDGE));
  m_colors = static_cast<vpTrackedColors *>(part(COLOR));
  m_points = static_cast<vpTrackedPoints *>(part(POINT));
  m_used = ofType(m_type);
}

std::vector<vpCueSet::Used> vpCueSet::ofType(int type) const
{
  std::vector<Used> used;
  for (std::size_t i = 0; i < m_cues.size(); ++i) { // Kinds that came later are not this tracker's.
    const vpCueKind &kind = vpCueKinds::all()[i];
    if ((type & kind.type) != 0) {
      used.push_back({&kind, m_cues[i].get()});
    }
  }
  return used;
}

void vpCueSet::setType(int type, vpModelLooks &looks)
{
  const std::vector<Used> used = ofType(type);
  for (const Used &one : used) {
    one.cue->setUsed(true, looks);
  }
  for (const Used &one : m_used) {
    if ((type & one.kind->type) == 0) {
      one.cue->setUsed(false, looks);
    }
  }
  m_type = type;
  m_used = used;
}

const vpCueSet::Used &vpCueSet::find(int type) const
{
  return *std::find_if(m_used.begin(), m_used.end(), [type](const Used &one) { return one.kind->type == type; });
}

void vpCueSet::forget(vpModelLooks &looks)
{
  for (const std::unique_ptr<vpTrackedCue> &cue : m_cues) {
    cue->forget(looks);
  }
}

END_VISP_NAMESPACE
