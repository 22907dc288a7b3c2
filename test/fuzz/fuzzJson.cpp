// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzJson.cpp Fuzzes the reader of JSON configurations.
#include "fuzzFile.h"

#include <visp3/multicue/vpMultiCueSettings.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  return fuzz::readFile("settings.json", data, size,
                        [](const std::string &file) { vpMultiCueSettingsReader::read(file, vpMultiCueSettings()); });
}
