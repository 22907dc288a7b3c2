// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchWorkers_h
#define benchWorkers_h

#include <functional>
#include <string>
#include <vector>

namespace bench {

//! A piece of work that runs in a process of its own: if it crashes, the others go on.
struct Work
{
  std::string name;
  std::size_t size = 0;                                              //!< Number of times that it will say "one more".
  std::function<void(const std::function<void()> &oneMore)> execute; //!< May throw. Results go into files.
};

/*!
  Runs all of the work, \e jobs at a time, with a progress bar where the error stream is a terminal.
  \param log File that what the work prints is appended to: libraries chatter.
  \return For each work why it failed, empty where it did not.
*/
std::vector<std::string> runWork(const std::vector<Work> &works, int jobs, const std::string &log);

} // namespace bench
#endif
