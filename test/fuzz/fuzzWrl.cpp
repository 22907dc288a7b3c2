// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzWrl.cpp Fuzzes the reader of .wrl models.
#include "fuzzFile.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  return fuzz::readFile("model.wrl", data, size, [](const std::string &file) {
    vpMbMultiCueTracker(vpMbMultiCueTracker::EDGE_TRACKER).loadModel(file);
  });
}
