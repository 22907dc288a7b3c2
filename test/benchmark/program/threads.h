// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchThreads_h
#define benchThreads_h

namespace bench {

//! Number of threads that OpenCV and OpenMP may take in this process from now on. \param count 1 or more.
void setThreads(int count);

} // namespace bench
#endif
