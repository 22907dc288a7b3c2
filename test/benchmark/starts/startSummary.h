// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchStartSummary_h
#define benchStartSummary_h

#include "evaluate/benchTracker.h"
#include "evaluate/poseError.h"
#include "starts/startOptions.h"

namespace bench {

//! How a trial ended.
enum class StartOutcome
{
  RIGHT,  //!< Accepted, and the pose is right.
  WRONG,  //!< Accepted, and it is not.
  REFUSED //!< Not accepted: the state is not TRACKING, or the tracker did not take the pose at all.
};

std::string toString(StartOutcome outcome);

//! A trial and what came of it.
struct StartRecord
{
  std::string tracker, object, model; //!< Names.
  std::string scene, imageScene;
  int frame = 0, imageFrame = 0; //!< SequenceFrame::id of the first image.
  StartDeviation deviation;
  StartOutcome outcome = StartOutcome::REFUSED;
  vpTrackingState state = vpTrackingState::LOST; //!< At the end, as all that follows.
  double score = 0.;                             //!< Not a number where the tracker has none.
  bool right = false;                            //!< The pose, accepted or not; never for wrong starts.
  double translation = 0.; //!< Error, metres; not a number for wrong starts, where there is nothing to be off.
  double rotation = 0.;    //!< Error, degrees, likewise.
};

//! Trials of one kind in numbers; shares are in [0, 1].
struct StartSummary
{
  std::string tracker, object, model; //!< "all" for all objects.
  StartDeviation deviation;
  std::size_t trials = 0;
  double right = 0.;     //!< Share that was accepted and is right.
  double wrong = 0.;     //!< Share that was accepted and is not.
  double refused = 0.;   //!< Share that was refused.
  double poseRight = 0.; //!< Share whose pose is right, accepted or not.
};

//! \return A summary of each tracker, deviation, object and model, in the order of the records; then of all models of
//! an object and of all objects, where there are several.
std::vector<StartSummary> summariseStarts(const std::vector<StartRecord> &records);

//! starts.csv: a line for each trial.
std::string startsCsv(const std::vector<StartRecord> &records);
//! summary.csv: a line for each summary.
std::string startSummaryCsv(const std::vector<StartSummary> &summaries);
//! Shares in percent; with several deviations as tables of angle against offset.
std::string startMarkdown(const std::vector<StartSummary> &summaries);

} // namespace bench
#endif
