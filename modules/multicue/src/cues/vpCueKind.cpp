// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpCueKind.h>

#include "cues/vpTrackedColors.h"
#include "cues/vpTrackedEdges.h"
#include "cues/vpTrackedPoints.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

namespace {
template <typename Cue> std::unique_ptr<vpTrackedCue> make()
{
  return std::make_unique<Cue>();
}

std::deque<vpCueKind> &kinds()
{
  using Tracker = vpMbMultiCueTracker;
  static std::deque<vpCueKind> list = {
      {Tracker::EDGE_TRACKER, "edge", "EDGE_TRACKER", vpCueVote::EDGES, &make<vpTrackedEdges>},
      {Tracker::COLOR_TRACKER, "color", "COLOR_TRACKER", vpCueVote::BESIDE_EDGES, &make<vpTrackedColors>},
      {Tracker::KLT_TRACKER, "point", "KLT_TRACKER", vpCueVote::POINTS, &make<vpTrackedPoints>}};
  return list;
}

bool isOneBit(int type)
{
  return type > 0 && (type & (type - 1)) == 0;
}
} // namespace

const std::deque<vpCueKind> &vpCueKinds::all()
{
  return kinds();
}

void vpCueKinds::add(const vpCueKind &kind)
{
  const bool isTaken = std::any_of(kinds().begin(), kinds().end(), [&kind](const vpCueKind &other) {
    return other.type == kind.type || other.name == kind.name;
  });
  if (!isOneBit(kind.type) || kind.name.empty() || !kind.make || isTaken) {
    throw vpException(vpException::badValue,
                      "Kind of cue '%s' with type %d cannot be added: give it a type of one bit, a name that no other "
                      "one has, and a function that makes it",
                      kind.name.c_str(), kind.type);
  }
  if (kinds().size() >= most) {
    throw vpException(vpException::badValue, "Kind of cue '%s' is one too many: there may be %u", kind.name.c_str(),
                      static_cast<unsigned int>(most));
  }
  kinds().push_back(kind);
}

const vpCueKind *vpCueKinds::find(int type)
{
  const auto found =
      std::find_if(kinds().begin(), kinds().end(), [type](const vpCueKind &kind) { return kind.type == type; });
  return found == kinds().end() ? nullptr : &*found;
}

std::size_t vpCueKinds::indexOf(int type)
{
  std::size_t index = 0;
  while (kinds()[index].type != type) {
    ++index;
  }
  return index;
}

int vpCueKinds::allTypes()
{
  int sum = 0;
  for (const vpCueKind &kind : kinds()) {
    sum |= kind.type;
  }
  return sum;
}

std::string vpCueKinds::listText()
{
  std::string text;
  for (const vpCueKind &kind : kinds()) {
    text += (text.empty() ? "" : ", ") + kind.constant + " (" + std::to_string(kind.type) + ")";
  }
  return text;
}

END_VISP_NAMESPACE
