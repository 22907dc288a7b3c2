// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef processorTime_h
#define processorTime_h

#include <ctime>

//! Seconds of processor that this program had so far, in all its threads: what else the machine does does not count.
inline double processorTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

#endif
