// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzTrack.cpp Fuzzes vpMbMultiCueTracker: see fuzzSession.h.
#include "fuzzSession.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  return fuzz::runSession(data, size, fuzz::Calls::ALL);
}
