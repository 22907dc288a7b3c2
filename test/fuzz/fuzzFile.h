// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fuzzFile_h
#define fuzzFile_h

#include <meshFiles.h>

#include <visp3/core/vpException.h>

#include <cstdint>
#include <string>

namespace fuzz {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! Writes the bytes to a file, and has it read: vpException is an answer, anything else that leaves is a fault.
template <typename Read>
int readFile(const std::string &name, const std::uint8_t *data, std::size_t size, const Read &read)
{
  static const meshFiles::TemporaryFolder folder;
  const std::string path = folder.write(name, std::string(reinterpret_cast<const char *>(data), size));
  try {
    read(path);
  } catch (const vpException &) { // Refused by name.
  }
  return 0;
}
} // namespace fuzz

#endif
