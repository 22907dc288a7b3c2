// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchAnywhereTrials_h
#define benchAnywhereTrials_h

#include "anywhere/anywhereOptions.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace bench {

//! How starts without a pose ended, of one object.
struct AnywhereCount
{
  std::string object;
  int images = 0;
  int acceptedRight = 0;
  int acceptedWrong = 0;
  int refusedRight = 0;           //!< The pose that was refused is right.
  int followedRight = 0;          //!< TRACKING and right after the images that follow.
  int followedWrong = 0;          //!< TRACKING and wrong.
  std::vector<double> seconds;    //!< Of each call but the first, which prepares the model.
  std::vector<double> cpuSeconds; //!< Of the process.
  double first = 0.;              //!< Of the first call, process seconds.

  void add(const AnywhereCount &other);
  //! \return The value that this share of the calls does not exceed; not a number without calls.
  static double quantile(std::vector<double> values, double share);
};

//! Tells what becomes of each image on \e log, and fills the table. \throw vpException as openScenes().
std::vector<AnywhereCount> runAnywhere(const AnywhereOptions &options, std::ostream &log);

//! A table in Markdown, the sum of all objects last.
std::string anywhereMarkdown(const std::vector<AnywhereCount> &counts, bool follows);

} // namespace bench
#endif
