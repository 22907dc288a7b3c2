// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzFollow.cpp Fuzzes vpMbMultiCueTracker without its search: see fuzzSession.h. Many more inputs in the same
//! time.
#include "fuzzSession.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  return fuzz::runSession(data, size, fuzz::Calls::WITHOUT_SEARCH);
}
