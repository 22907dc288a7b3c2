// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-benchmark.cpp
  Times each stage of tracking by itself, for models of different size and images of different size, and whole frames
  beside ViSP's vpMbGenericTracker(EDGE_TRACKER). Draws its images itself; needs no file and no display.

  Names are stage/model/size of the image: --benchmark_filter=match/lump-30k runs three of them. Those of what is done
  once for a model have no size: load/obj-1000k, diameter/200k.
*/
#include "stages/benchFailure.h"
#include "stages/cueStages.h"
#include "stages/loadStages.h"
#include "stages/modelStages.h"
#include "stages/searchStages.h"
#include "stages/trackerStages.h"

#include <visp3/core/vpException.h>

#include <benchmark/benchmark.h>

namespace {
enum class Models
{
  ALL,
  BOX_ALONE //!< ViSP reads it, or the model does not matter.
};

struct Stage
{
  const char *name;
  void (*run)(benchmark::State &state, bench::BenchScene &scene);
  Models models;
  bool ownClock; //!< The stage takes the time itself.
};

// A new stage is a line here.
const std::vector<Stage> stages = {
    {"render-depth", bench::renderDepth, Models::ALL, false},
    {"view", bench::computeView, Models::ALL, false},
    {"sphere-view", bench::makeSphereView, Models::ALL, false},
    {"sphere-nearest", bench::findSphereView, Models::BOX_ALONE, false},
    {"sphere-project", bench::projectSphereView, Models::BOX_ALONE, false},
    {"frame-gray", bench::frameOfGray, Models::BOX_ALONE, false},
    {"frame-color", bench::frameOfColor, Models::BOX_ALONE, false},
    {"frame-distorted", bench::frameOfDistorted, Models::BOX_ALONE, false},
    {"distance-map", bench::mapDistances, Models::BOX_ALONE, false},
    {"color-odds-map", bench::mapColorOdds, Models::BOX_ALONE, false},
    {"match-edges", bench::matchEdges, Models::ALL, false},
    {"match-color", bench::matchColor, Models::ALL, false},
    {"match-color-levels", bench::matchColorLevels, Models::ALL, false},
    {"match-points", bench::matchPoints, Models::ALL, false},
    {"surface-frame", bench::reduceSurfaceFrame, Models::BOX_ALONE, false},
    {"surface-learn", bench::learnSurface, Models::BOX_ALONE, false},
    {"surface-agreement", bench::agreeWithSurface, Models::BOX_ALONE, false},
    {"particle-likelihood", bench::scorePose, Models::BOX_ALONE, false},
    {"silhouette-step", bench::stepSilhouette, Models::BOX_ALONE, false},
    {"vvs-iteration", bench::iterateVvs, Models::ALL, false},
    {"track", bench::trackOurs, Models::ALL, false},
    {"track-visp", bench::trackVisp, Models::BOX_ALONE, false},
    {"track-both", bench::trackBoth, Models::BOX_ALONE, true},
};

void add(const Stage &stage, std::size_t shape, std::size_t size)
{
  const std::string name =
      std::string(stage.name) + "/" + bench::benchShapes()[shape].name + "/" + bench::benchSizes()[size].name;
  auto *entry = benchmark::RegisterBenchmark(name.c_str(), [&stage, shape, size](benchmark::State &state) {
    try {
      stage.run(state, bench::benchScene(shape, size));
    } catch (const vpException &e) {
      bench::failBenchmark(state, e.what());
    }
  });
  entry->Unit(benchmark::kMicrosecond);
  if (stage.ownClock) {
    entry->UseManualTime();
  }
}

void addLoading()
{
  for (const bench::LoadedFile &file : bench::loadedFiles()) {
    const auto load = [&file](benchmark::State &state) { bench::loadFile(state, file); };
    benchmark::RegisterBenchmark(("load/" + file.name()).c_str(), load)->Unit(benchmark::kMillisecond);
  }
  for (const int triangles : {60000, 400000}) { // Half as many vertices.
    const auto measure = [triangles](benchmark::State &state) { bench::measureDiameter(state, triangles); };
    const std::string name = "diameter/" + std::to_string(triangles / 2000) + "k";
    benchmark::RegisterBenchmark(name.c_str(), measure)->Unit(benchmark::kMillisecond);
  }
}
} // namespace

int main(int argc, char **argv)
{
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 1;
  }
  for (const Stage &stage : stages) {
    const std::size_t shapes = stage.models == Models::ALL ? bench::benchShapes().size() : 1;
    for (std::size_t shape = 0; shape < shapes; ++shape) {
      for (std::size_t size = 0; size < bench::benchSizes().size(); ++size) {
        add(stage, shape, size);
      }
    }
  }
  addLoading();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return bench::anyFailed() ? 1 : 0;
}
