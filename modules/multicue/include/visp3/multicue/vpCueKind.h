// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCueKind_h
#define vpCueKind_h

#include <visp3/multicue/vpTrackedCue.h>

#include <deque>
#include <functional>
#include <memory>
#include <string>

BEGIN_VISP_NAMESPACE

//! \ingroup group_multicue
//! How a cue's agreement with a pose counts beside that of other cues.
enum class vpCueVote
{
  EDGES,        //!< They are there in any light, and tell how much the others may say.
  BESIDE_EDGES, //!< As a share of what it had at trusted poses, the less the more that varied.
  POINTS        //!< While the object is followed, by those that were found again.
};

//! \ingroup group_multicue
//! A kind of cue. All that names cues, in types, configurations, results and programs, comes from the list of kinds.
struct vpCueKind
{
  int type = 0;         //!< One bit, as in vpMbMultiCueTracker::setTrackerType().
  std::string name;     //!< In configurations and results.
  std::string constant; //!< In C++.
  vpCueVote vote = vpCueVote::BESIDE_EDGES;
  std::function<std::unique_ptr<vpTrackedCue>()> make;
};

/*!
  \ingroup group_multicue
  The list of kinds of cues, in the order in which their equations are stacked: the scale of the first one that takes
  part is the one that all others are brought to.
*/
class VISP_EXPORT vpCueKinds
{
public:
  static constexpr std::size_t most = 8;

  static const std::deque<vpCueKind> &all();
  /*!
    Adds a kind, for trackers that are made from then on.
    \throw vpException where its type is no single bit or is taken, its name is taken or empty, it cannot be made, or
    there are \e most kinds.
  */
  static void add(const vpCueKind &kind);
  //! \return The kind of one type, null where there is none.
  static const vpCueKind *find(int type);
  //! \return Place in the list. \param type Of a kind that there is.
  static std::size_t indexOf(int type);
  //! \return All types in one sum.
  static int allTypes();
  //! \return For messages, such as "vpMbMultiCueTracker::EDGE_TRACKER (1), ...".
  static std::string listText();
};

END_VISP_NAMESPACE
#endif
