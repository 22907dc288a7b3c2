// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef exceptionMessage_h
#define exceptionMessage_h

#include <visp3/core/vpException.h>

#include <string>

//! \return The message of ViSP's exception that a call ends with; empty where it ends without one.
template <typename Call> std::string messageOf(const Call &call)
{
  try {
    call();
  } catch (const vpException &e) {
    return e.getMessage();
  }
  return "";
}

#endif
