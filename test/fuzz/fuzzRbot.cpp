// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzRbot.cpp Fuzzes the readers of RBOT's files: the first byte chooses poses or camera.
#include "fuzzDataset.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  static const fuzz::Dataset rbot(
      [](const DatasetFolder &folder) { putRbot(folder); }, {"poses_first.txt", "camera_calibration.txt"},
      [](const DatasetFolder &folder) { return bench::openSequence(folder.path(), "ape/a_regular"); });
  return rbot.read(data, size);
}
