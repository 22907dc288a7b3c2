// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef memoryLimit_h
#define memoryLimit_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <string>

#ifdef __linux__
#include <sys/resource.h>
#endif

/*!
  \file memoryLimit.h
  Memory for a while: what takes more ends in std::bad_alloc.
*/

BEGIN_VISP_NAMESPACE
namespace fileVariants {
//! Lets this process take no more than so many bytes in addition to what it has, as long as this lives.
class MemoryLimit
{
public:
  explicit MemoryLimit(std::size_t bytes)
  {
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    getrlimit(RLIMIT_DATA, &m_before);
    rlimit limit = m_before;
    limit.rlim_cur = std::min<rlim_t>(m_before.rlim_cur, dataBytes() + bytes);
    m_isSet = setrlimit(RLIMIT_DATA, &limit) == 0;
#else
    static_cast<void>(bytes); // Sanitizers take memory for themselves.
#endif
  }
  ~MemoryLimit()
  {
#ifdef __linux__
    if (m_isSet) {
      setrlimit(RLIMIT_DATA, &m_before);
    }
#endif
  }
  MemoryLimit(const MemoryLimit &) = delete;
  MemoryLimit &operator=(const MemoryLimit &) = delete;

private:
#ifdef __linux__
  // What the limit counts already.
  static rlim_t dataBytes()
  {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
      rlim_t kilobytes = 0;
      if (word == "VmData:" && status >> kilobytes) {
        return kilobytes * 1024;
      }
    }
    return 0;
  }

  rlimit m_before = {};
  bool m_isSet = false;
#endif
};
} // namespace fileVariants
END_VISP_NAMESPACE
#endif
