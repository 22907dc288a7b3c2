// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSummary_h
#define benchSummary_h

#include "evaluate/stateFigures.h"

#include <map>

namespace bench {

//! What a run is: a line of summary.csv.
struct RunKey
{
  std::string scene;
  std::string tracker;
  Protocol protocol = Protocol::RBOT;
  int step = 1;

  //! A name for files, without characters that file systems dislike.
  std::string fileName() const;
};

//! A stretch of frames in which a tracker was wrong.
struct Loss
{
  int lost = -1; //!< Its first wrong frame.
  int back = -1; //!< The first of the right ones after it; -1 where there is none.
};

//! A run in numbers. Shares are in [0, 1]; what has no value is not a number, or -1 for frames.
struct RunSummary
{
  RunKey key;
  std::size_t frames = 0;    //!< That count.
  double success = 0.;       //!< Share of the counted frames.
  double right = 0.;         //!< Share of the counted frames.
  int firstLost = -1;        //!< Frame where the first loss begins.
  int back = -1;             //!< Frame where the first loss ends.
  double falseTracking = 0.; //!< Share of the counted frames whose state is TRACKING and whose pose is not right.
  double translationMedian = 0., translation95 = 0.;  //!< Of the successful frames, mm.
  double rotationMedian = 0., rotation95 = 0.;        //!< Of the successful frames, degrees.
  double pixelsMedian = 0.;                           //!< Of the successful frames.
  double addAuc = 0.;                                 //!< Of all counted frames; ADD-S for objects with symmetries.
  double addsAuc = 0.;                                //!< ADD-S of all counted frames.
  double msMedian = 0., ms95 = 0.;                    //!< Of all tracked frames.
  double minimisations = 0.;                          //!< Mean of TrackerAnswer::minimisations over all tracked frames.
  std::vector<std::pair<std::string, double>> stages; //!< Name and median, ms.
  std::vector<Loss> losses;                           //!< All of them; the first is firstLost and back.
  StateFigures state;                                 //!< Of this run alone.
};

/*!
  A loss begins with 5 counted frames on end that are not right, and ends with 5 on end that are.
  \param records In the order of time.
*/
std::vector<Loss> findLosses(const std::vector<FrameRecord> &records);

//! \param stages Names of TrackerAnswer::stages.
RunSummary summarise(const RunKey &key, const std::vector<FrameRecord> &records, double diameter, bool symmetric,
                     const std::vector<std::string> &stages);

//! Value at share \e q of the sorted values; not a number where there is none.
double quantile(std::vector<double> values, double q);

} // namespace bench
#endif
