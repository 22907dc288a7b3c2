// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchFailure_h
#define benchFailure_h

#include <benchmark/benchmark.h>

namespace bench {

//! Whether a benchmark failed: Google Benchmark prints that, and ends the program as if nothing had been.
inline bool &anyFailed()
{
  static bool failed = false;
  return failed;
}

//! Ends a benchmark without a time; its loop has to be left as well.
inline void failBenchmark(benchmark::State &state, const char *reason)
{
  anyFailed() = true;
  state.SkipWithError(reason);
}

} // namespace bench
#endif
