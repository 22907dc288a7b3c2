// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFrameDeadline_h
#define vpFrameDeadline_h

#include <visp3/multicue/vpPutOff.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE

//! A moment after which a loop is left; never, where there is none.
class vpTimeLimit
{
public:
  using Clock = std::chrono::steady_clock;

  vpTimeLimit() = default;
  explicit vpTimeLimit(Clock::time_point end) : m_isLimited(true), m_end(end) {}
  bool isLimited() const { return m_isLimited; }
  bool isOver() const { return m_isLimited && Clock::now() >= m_end; }

private:
  bool m_isLimited = false;
  Clock::time_point m_end;
};

/*!
  When a frame has to end, and what it puts off for that; without a deadline, nothing is put off.

  Each kind of work is begun only where the time that it took lately fits in before the end. What ends a frame, whatever
  was found, has its time kept free. Where a machine is so slow that searches are put off in several frames on end, the
  next one takes longer: a lost object would never be found again.
*/
class vpFrameDeadline
{
public:
  using Clock = vpTimeLimit::Clock;
  static constexpr double longest = 10000.; //!< Milliseconds.

  //! \param milliseconds Of a frame; 0: no deadline. \throw vpException where it is outside [0, longest].
  void set(double milliseconds);
  double get() const { return m_milliseconds; }
  bool isLimited() const { return m_milliseconds > 0.; }

  void startFrame();
  //! Since the frame began, milliseconds.
  double elapsed() const { return std::chrono::duration<double, std::milli>(Clock::now() - m_begin).count(); }
  //! What is left until the frame's end has to begin, milliseconds; infinite without a deadline.
  double left() const;
  //! True, and noted, where one more piece of such work would not end in time.
  bool putsOff(vpPutOff work);
  //! Noted: such work was broken off.
  void notePutOff(vpPutOff work);
  //! What this frame put off, each once.
  const std::vector<vpPutOff> &putOff() const { return m_putOff; }
  //! The moment at which this share of what is left is spent.
  vpTimeLimit after(double share) const;

  //! Such work took so long, milliseconds.
  void learn(vpPutOff work, double duration) { durationOf(work).learn(duration); }
  //! All that comes when the poses were looked for did.
  void learnEnding(double duration) { m_ending.learn(duration); }

private:
  //! The most that a kind of work took lately.
  struct Duration
  {
    void learn(double duration);
    double most = 0.;
  };
  Duration &durationOf(vpPutOff work) { return m_durations[static_cast<std::size_t>(work)]; }

  double m_milliseconds = 0.;
  double m_end = 0.;               // Of this frame, milliseconds.
  unsigned int m_hungryFrames = 0; // On end, that put a search off.
  bool m_isSearchPutOff = false;
  Clock::time_point m_begin;
  std::vector<vpPutOff> m_putOff;
  Duration m_ending;
  std::array<Duration, static_cast<std::size_t>(vpPutOff::COMPARISON) + 1> m_durations;
};

//! Tells a deadline how long a piece of work took.
class vpTimedWork
{
public:
  vpTimedWork(vpFrameDeadline &deadline, vpPutOff work)
      : m_deadline(deadline), m_work(work), m_begin(deadline.elapsed())
  {
  }
  ~vpTimedWork() { m_deadline.learn(m_work, m_deadline.elapsed() - m_begin); }
  vpTimedWork(const vpTimedWork &) = delete;
  vpTimedWork &operator=(const vpTimedWork &) = delete;

private:
  vpFrameDeadline &m_deadline;
  vpPutOff m_work;
  double m_begin;
};

END_VISP_NAMESPACE
#endif
