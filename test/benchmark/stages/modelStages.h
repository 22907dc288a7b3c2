// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchModelStages_h
#define benchModelStages_h

#include "stages/benchScene.h"

#include <benchmark/benchmark.h>

/*!
  \file modelStages.h
  The model's side of a frame.
*/

namespace bench {

//! The depth of the whole object, every pixel of the image.
inline void renderDepth(benchmark::State &state, BenchScene &scene)
{
  vpCpuRenderer renderer(scene.model());
  const vpRenderOptions options;
  vpRenderedView view;
  int k = 0;
  for (auto _ : state) {
    renderer.render(BenchScene::pose(k++), scene.camera(), scene.width(), scene.height(), options, view);
  }
  state.counters["pixels"] = static_cast<double>(view.depth.size());
}

//! The control points that are seen, with the small depth buffer that a model needs which is not convex.
inline void computeView(benchmark::State &state, BenchScene &scene)
{
  vpCpuRenderer renderer(scene.model());
  vpModelView view(scene.model());
  int k = 0;
  for (auto _ : state) {
    view.compute(BenchScene::pose(k++), scene.camera(), scene.width(), scene.height(), scene.viewOptions(), &renderer);
  }
  state.counters["points"] = static_cast<double>(view.points().size());
}

} // namespace bench
#endif
