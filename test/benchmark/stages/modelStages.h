// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchModelStages_h
#define benchModelStages_h

#include "stages/benchScene.h"

#include <visp3/model/vpViewSphere.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

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

//! A view of the finest sphere, one after the other; what is not of one view is made beforehand.
inline void makeSphereView(benchmark::State &state, BenchScene &scene)
{
  const auto fresh = [&scene] {
    return vpViewSphere(scene.model(), vpViewSphereOptions(), std::make_unique<vpCpuRenderer>(scene.model()));
  };
  vpViewSphere sphere = fresh();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sphere.view(i).size());
    if (++i == sphere.size()) {
      state.PauseTiming();
      sphere = fresh();
      i = 0;
      state.ResumeTiming();
    }
  }
  state.counters["points"] = static_cast<double>(sphere.view(0).size());
}

//! The direction from which a pose sees the object.
inline void findSphereView(benchmark::State &state, BenchScene &scene)
{
  const vpViewSphere sphere(scene.model(), vpViewSphereOptions(), std::make_unique<vpCpuRenderer>(scene.model()));
  std::vector<vpHomogeneousMatrix> poses; // Not all alike: what is near is in the processor's cache.
  for (int k = 0; k < 1024; ++k) {
    poses.push_back(BenchScene::pose(0) * vpHomogeneousMatrix(0., 0., 0., 0.7 * k, 0.31 * k, 0.13 * k));
  }
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sphere.nearest(poses[k++ % poses.size()]));
  }
}

//! The points of a view of the sphere, brought to a pose: what each particle needs at least.
inline void projectSphereView(benchmark::State &state, BenchScene &scene)
{
  vpViewSphere sphere(scene.model(), vpViewSphereOptions(), std::make_unique<vpCpuRenderer>(scene.model()));
  const vpHomogeneousMatrix cMo = BenchScene::pose(0);
  const vpSphereView &view = sphere.view(sphere.nearest(cMo));
  std::array<float, 12> m;
  std::transform(cMo.data, cMo.data + 12, m.begin(), [](double value) { return static_cast<float>(value); });
  const float focal = static_cast<float>(scene.camera().get_px());
  std::vector<float> u(view.size());
  std::vector<float> v(view.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < view.size(); ++i) {
      const float x = view.x()[i];
      const float y = view.y()[i];
      const float z = view.z()[i];
      const float scale = focal / (m[8] * x + m[9] * y + m[10] * z + m[11]);
      u[i] = (m[0] * x + m[1] * y + m[2] * z + m[3]) * scale;
      v[i] = (m[4] * x + m[5] * y + m[6] * z + m[7]) * scale;
    }
    benchmark::DoNotOptimize(u.data());
    benchmark::ClobberMemory();
  }
  state.counters["points"] = static_cast<double>(view.size());
}

} // namespace bench
#endif
