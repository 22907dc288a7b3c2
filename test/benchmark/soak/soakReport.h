// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSoakReport_h
#define benchSoakReport_h

#include <string>
#include <vector>

namespace bench {

//! What happened in the frames since the last figures.
struct SoakCounts
{
  int frames = 0;
  int tracking = 0;    //!< Frames that were TRACKING.
  int refused = 0;     //!< Calls that ended with vpException.
  double seconds = 0.; //!< Processor time of track() alone, of all threads.
  int trackers = 0;    //!< Made anew.
};

//! Memory and open files of this process over the frames.
class SoakReport
{
public:
  void add(int frame, const SoakCounts &counts);
  std::string lastLine() const;
  //! Of memory and open files, as a sentence.
  std::string growth() const;
  //! More than a robot could live with for weeks.
  bool grows() const;

private:
  struct Line
  {
    int frame = 0;
    double megabytes = 0.; //!< Resident.
    int files = 0;
    SoakCounts counts;
  };
  double megabytesPer10000() const;
  int filesMore() const;

  std::vector<Line> m_lines;
};

} // namespace bench
#endif
