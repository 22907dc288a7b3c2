// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/threads.h"

#include <opencv2/core/utility.hpp>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace bench {

void setThreads(int count)
{
  cv::setNumThreads(count);
#ifdef _OPENMP
  omp_set_num_threads(count);
#endif
}

} // namespace bench
