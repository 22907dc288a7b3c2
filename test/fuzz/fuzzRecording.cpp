// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzRecording.cpp Fuzzes the readers of a recording's files: the first byte chooses pose or camera.
#include "fuzzDataset.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  static const fuzz::Dataset recording([](const DatasetFolder &folder) { putSmallRecording(folder); },
                                       {"pose1.txt", "camera.xml"}, openSmallRecording);
  return recording.read(data, size);
}
