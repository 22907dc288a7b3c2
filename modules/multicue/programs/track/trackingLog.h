// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsTrackingLog_h
#define programsTrackingLog_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpWholeFile.h>
#include <visp3/multicue/vpTrackingState.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! What is known of a frame after it was tracked.
struct TrackedFrame
{
  int number = 0;                                     //!< Of the frame in its source.
  vpHomogeneousMatrix cMo;                            //!< Object to camera, metres.
  double milliseconds = 0.;                           //!< That track() took.
  vpTrackingState state = vpTrackingState::UNCERTAIN; //!< How it went.
  double score = 0.;                                  //!< How far to believe the pose, [0, 1].
};

//! Writes the poses while the program runs, and a summary at the end. The files have their names when finish() is
//! done; until then, those of an earlier run are there.
class TrackingLog
{
public:
  /*!
    \param posesFile CSV file, empty for none.
    \param summaryFile Text file, empty for none.
    \throw vpException naming the file that cannot be written.
  */
  TrackingLog(const std::string &posesFile, const std::string &summaryFile);

  //! Adds a frame.
  void add(const TrackedFrame &frame);

  //! \param degrees See vpMbTracker::computeCurrentProjectionError().
  void addProjectionError(double degrees) { m_projectionErrors.push_back(degrees); }

  //! \return The summary as text, one "name: value" a line.
  std::string summary() const;

  //! Writes the summary, and puts both files in their places. \throw vpException naming a file that could not be
  //! written to its end.
  void finish();

private:
  std::unique_ptr<vpWholeFile> m_poses;
  std::unique_ptr<vpWholeFile> m_summary;
  std::vector<double> m_milliseconds;
  std::vector<double> m_projectionErrors;
  std::map<vpTrackingState, int> m_states;
};

} // namespace programs
#endif
