// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchLoadStages_h
#define benchLoadStages_h

#include "stages/loadedFiles.h"
#include "stages/peakMemory.h"

#include "dataset/largestDistance.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <benchmark/benchmark.h>

#include <string>

/*!
  \file loadStages.h
  What is done once for a model, which grows with the number of its triangles: its file is read, and its size measured.
*/

namespace bench {

//! loadModel() of a tracker, with the memory that it takes at most, and the one that the tracker keeps.
inline void loadFile(benchmark::State &state, const LoadedFile &what)
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = what.write(folder);
  std::size_t triangles = 0;
  double most = 0.;
  double kept = 0.;
  for (auto _ : state) {
    const PeakMemory memory;
    vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
    tracker.loadModel(file, false);
    most = memory.most();
    kept = memory.now();
    triangles = tracker.getModel()->triangles().size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["most_MB"] = most;
  state.counters["kept_MB"] = kept;
}

//! The largest distance of two vertices, which a data set tells of its objects.
inline void measureDiameter(benchmark::State &state, int triangles)
{
  const SharedMesh mesh(triangles);
  for (auto _ : state) {
    benchmark::DoNotOptimize(programs::largestDistance(mesh.vertices));
  }
  state.counters["vertices"] = static_cast<double>(mesh.vertices.size());
}

} // namespace bench
#endif
