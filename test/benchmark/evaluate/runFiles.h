// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchRunFiles_h
#define benchRunFiles_h

#include "evaluate/summary.h"

namespace bench {

//! A run as it is kept: its frames as .csv for anybody to read, and as .json what a resumed evaluation needs of it.
struct RunResult
{
  RunSummary summary;
  std::vector<FrameRecord> records; //!< Of each: frame, pose, ms, reset, state, score, counted, success, right, error.
};

/*!
  Writes <folder>/<name>.csv (frame, 12 numbers of cMo row by row, ms, reset, state, score, minimisations) and
  <folder>/<name>.json. Each is complete or not there at all. \param fingerprint Of all that the result depends on.
  \throw vpException naming the file that cannot be written.
*/
void writeRun(const std::string &folder, const RunResult &run, const std::string &fingerprint);

//! \return False where the run is not there, was cut off, or has another fingerprint or format.
bool readRun(const std::string &folder, const RunKey &key, const std::string &fingerprint, double diameter,
             bool symmetric, RunResult &run);

} // namespace bench
#endif
