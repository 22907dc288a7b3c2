// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsDemoRecord_h
#define programsDemoRecord_h

#include "demo/demoTracker.h"

#include <string>
#include <vector>

namespace programs {

//! What one tracker made of one sequence, image by image.
class DemoRecord
{
public:
  //! One image.
  struct Frame
  {
    int number = 0;
    vpTrackingState state = vpTrackingState::LOST;
    double milliseconds = 0.;
    bool isShown = true;         //!< At least a fifth of the object is seen.
    bool isRight = false;        //!< By the truth, where there is one.
    double translation = 0.;     //!< Error, metres.
    double rotation = 0.;        //!< Error, degrees.
    double projectionError = 0.; //!< Degrees, of sequences without truth.
  };

  DemoRecord(const DemoSequence &sequence, const std::string &tracker) : m_sequence(sequence), m_tracker(tracker) {}

  //! \return What was added, for the picture.
  const Frame &add(int number, const DemoAnswer &answer, double projectionError);
  //! Lines of text with the figures.
  std::vector<std::string> summary() const;
  const std::string &tracker() const { return m_tracker; }

private:
  std::vector<std::string> truthLines() const;
  //! Number of the image from which on the pose was wrong for five shown images on end; -1 for none.
  int firstLost() const;
  //! Number of the image after \e lost from which on it was right for five; -1 for none.
  int foundAgain(int lost) const;

  const DemoSequence &m_sequence;
  std::string m_tracker;
  std::vector<Frame> m_frames;
};

} // namespace programs
#endif
