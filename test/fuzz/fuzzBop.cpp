// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzBop.cpp Fuzzes the readers of BOP's files, that of symmetries among them: the first byte chooses the file.
#include "fuzzDataset.h"

#include <visp3/multicue/vpModelSymmetriesReader.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  const std::string scene = "test/000001/";
  const std::string info = "models/models_info.json";
  static const fuzz::Dataset bop(
      [](const DatasetFolder &folder) { putBop(folder); },
      {scene + "scene_gt.json", scene + "scene_camera.json", scene + "scene_gt_info.json", info},
      [info](const DatasetFolder &folder) {
        const bench::Sequence sequence = bench::openSequence(folder.path(), "test/000001", 5);
        static_cast<void>(vpModelSymmetriesReader::read(folder.path(info), 5));
        return sequence;
      });
  return bop.read(data, size);
}
