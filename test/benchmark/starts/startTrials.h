// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchStartTrials_h
#define benchStartTrials_h

#include "evaluate/imageStore.h"
#include "starts/startPlan.h"
#include "starts/startSummary.h"

namespace bench {

//! What came of all that was asked for.
struct StartResults
{
  std::vector<StartRecord> records;  //!< By tracker, object, deviation and number of the trial.
  std::vector<std::string> failures; //!< What could not be run, and why.
};

/*!
  Starts the tracker and tracks \e frames images.
  \param images Of the trial's imageScene. \param start Pose. \param deviation Tells the tracker how far off it may be.
  \param diameter Of the object that is looked for, metres.
  \return What the tracker says of the last image; LOST where it refused the pose.
  \throw vpException naming the image that cannot be read.
*/
TrackerAnswer tryStart(BenchTracker &tracker, ImageStore &images, const StartTrial &trial,
                       const vpHomogeneousMatrix &start, const StartDeviation &deviation, double diameter, int frames);

//! Runs all trials. \throw vpException as openScenes(), or where the folder of the results cannot be written.
StartResults runStarts(const StartOptions &options);

} // namespace bench
#endif
