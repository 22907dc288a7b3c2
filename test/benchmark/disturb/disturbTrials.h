// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchDisturbTrials_h
#define benchDisturbTrials_h

#include "disturb/footage.h"
#include "evaluate/poseError.h"

#include <visp3/se3/vpPoseRandom.h>

namespace bench {

//! How trials of one kind ended.
struct DisturbCount
{
  int trials = 0;
  int right = 0;
  int rightTracking = 0;      //!< Of them, those whose state says so.
  int wrongTracking = 0;      //!< Without notice.
  std::vector<double> pixels; //!< How far off each was in the end.
  std::vector<double> ms;     //!< Of the first images after the disturbance.

  std::vector<double> startMs; //!< Of the start.

  double median() const;
  double medianMs() const;
  double medianStartMs() const;
};

//! Starts and shifts of one tracker on one footage.
class DisturbTrials
{
public:
  //! Both have to outlive the trials.
  DisturbTrials(const DisturbOptions &options, const Footage &footage);

  //! Starts so many pixels off.
  DisturbCount starts(const std::string &tracker, int offset) const;
  //! Images that are shifted while the object is tracked.
  DisturbCount shifts(const std::string &tracker) const;

private:
  struct Shift
  {
    int right = 0;
    int down = 0;
  };

  void runShift(BenchTracker &tracker, std::size_t first, const Shift &by, DisturbCount &count) const;
  std::size_t pick(std::size_t length, vpPoseRandom &random) const;
  double pixelsOff(const vpHomogeneousMatrix &cMo, std::size_t frame, const Shift &shift) const;
  void judge(const TrackerAnswer &answer, std::size_t frame, const Shift &shift, DisturbCount &count) const;
  std::unique_ptr<BenchTracker> make(const std::string &tracker) const;

  const DisturbOptions &m_options;
  const Footage &m_footage;
  PoseErrorMeasure m_measure;
};

} // namespace bench
#endif
