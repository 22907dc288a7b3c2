// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef diskLimit_h
#define diskLimit_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <csignal>

#ifdef __unix__
#include <sys/resource.h>
#endif

/*!
  \file diskLimit.h
  A disk that is full after some bytes.
*/

BEGIN_VISP_NAMESPACE
//! As long as this lives, no file of this process grows beyond so many bytes.
class DiskLimit
{
public:
#ifdef __unix__
  explicit DiskLimit(unsigned long bytes)
  {
    getrlimit(RLIMIT_FSIZE, &m_before);
    rlimit limit = m_before;
    limit.rlim_cur = bytes;
    isSet = setrlimit(RLIMIT_FSIZE, &limit) == 0;
    m_handler = std::signal(SIGXFSZ, SIG_IGN); // Else it ends the process.
  }
  ~DiskLimit()
  {
    setrlimit(RLIMIT_FSIZE, &m_before);
    std::signal(SIGXFSZ, m_handler);
  }
#else
  explicit DiskLimit(unsigned long)
  {
  }
#endif
  DiskLimit(const DiskLimit &) = delete;
  DiskLimit &operator=(const DiskLimit &) = delete;

  bool isSet = false; //!< False where the system has no such limit.

#ifdef __unix__
private:
  rlimit m_before = {};
  void (*m_handler)(int) = nullptr;
#endif
};
END_VISP_NAMESPACE
#endif
