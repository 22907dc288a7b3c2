// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPastKnowledge_h
#define vpPastKnowledge_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  What was known of an object some frames ago, the farther back the sparser.

  An object that drifts off unnoticed is lost late, and what was learnt meanwhile speaks for the wrong pose: where the
  object is, how far away, and what it looks like. What was known before the drift does not. How long it lasted is
  unknown, so ages about double from one kept state to the next, and the first one stays.
*/
template <typename Known> class vpPastKnowledge
{
public:
  //! Frames from one state to the next, and how old a state has to be to be recalled at first.
  static constexpr unsigned long interval = 8;

  void clear()
  {
    m_states.clear();
    m_frames = 0;
    m_untilNext = 0;
  }
  std::size_t size() const { return m_states.size(); }

  //! One more frame that is learnt from. \return True where its state is to be kept.
  bool count()
  {
    ++m_frames;
    m_untilNext -= m_untilNext > 0 ? 1 : 0;
    return m_untilNext == 0;
  }
  void keep(Known known)
  {
    m_states.push_back({m_frames, std::move(known)});
    m_untilNext = interval;
    for (std::size_t i = m_states.size() - 1; i >= 2; --i) {
      if (ageOf(i - 2) <= 2 * ageOf(i)) {
        m_states.erase(m_states.begin() + static_cast<std::ptrdiff_t>(i) - 1);
      }
    }
  }

  //! \param level 0: the newest state that is old enough, and was learnt from some frames; 1: the next older one, and
  //! so on down to the first, then again from the newest. \return It, valid until a state is kept; null where there is
  //! none.
  const Known *recall(unsigned int level)
  {
    std::size_t states = m_states.size(); // That are old enough.
    while (states > 0 && m_frames - m_states[states - 1].frame < interval) {
      --states;
    }
    const std::size_t fewest = level == 0 ? 2 : 1; // The first state was learnt from one frame.
    if (states < fewest) {
      return nullptr;
    }
    m_recalled = states - 1 - level % states;
    return &m_states[m_recalled].known;
  }
  //! Forgets the newest ones of which this is true.
  template <typename Predicate> void dropNewest(Predicate isWrong)
  {
    while (!m_states.empty() && isWrong(m_states.back().known)) {
      m_states.pop_back();
    }
  }
  //! All that is kept and old enough, the oldest first.
  template <typename Function> void forEachOld(Function look) const
  {
    for (const State &state : m_states) {
      if (m_frames - state.frame >= interval) {
        look(state.known);
      }
    }
  }
  //! What was recalled last was right: forgets what is newer, and counts anew.
  void settle()
  {
    m_states.resize(std::min(m_states.size(), m_recalled + 1));
    m_untilNext = interval;
  }

private:
  struct State
  {
    unsigned long frame;
    Known known;
  };

  unsigned long ageOf(std::size_t i) const { return m_frames - m_states[i].frame + interval; }

  std::vector<State> m_states; // The oldest first.
  unsigned long m_frames = 0;
  unsigned long m_untilNext = 0;
  std::size_t m_recalled = 0;
};

END_VISP_NAMESPACE
#endif
