// SPDX-License-Identifier: GPL-2.0-or-later
//! \file fuzzXml.cpp Fuzzes the reader of XML configurations.
#include "fuzzFile.h"

#include <visp3/multicue/vpMultiCueSettings.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  return fuzz::readFile("settings.xml", data, size,
                        [](const std::string &file) { vpMultiCueSettingsReader::read(file, vpMultiCueSettings()); });
}
