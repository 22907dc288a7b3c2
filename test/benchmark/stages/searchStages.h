// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSearchStages_h
#define benchSearchStages_h

#include "search/vpContourAligner.h"
#include "search/vpPoseScore.h"
#include "stages/benchScene.h"

#include <visp3/cues/vpFrameSource.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/model/vpSurfaceSamples.h>
#include <visp3/se3/vpPoseExponential.h>
#include <visp3/se3/vpPoseRandom.h>

#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

/*!
  \file searchStages.h
  What a search does for each of the many poses that it looks at, and what it needs of a frame for that.
*/

namespace bench {

//! Everything that poses are judged by, learnt of the scene's image in colour.
struct SearchScene
{
  explicit SearchScene(BenchScene &scene)
      : frame(source.frame(scene.colorImage(), scene.camera(), nullptr)),
        sphere(scene.model(), sphereOptions(), std::make_unique<vpCpuRenderer>(scene.model()))
  {
    vpCpuRenderer renderer(scene.model());
    renderer.render(cMo, scene.camera(), scene.width(), scene.height(), vpRenderOptions(), depth);
    const vpImageRegion all(0, 0, static_cast<int>(scene.width()), static_cast<int>(scene.height()));
    learnColors(scene);
    odds.compute(frame, histograms, all);
    edges.compute(frame, all);
    memory.setSamples(vpSampleSurface(*scene.model(), 500));
    memory.setFrame(frame);
    memory.learn(cMo, nullptr);
    score.setSphere(&sphere);
    score.setImage(&edges, &odds, &memory, scene.camera(), scene.width(), scene.height());
    aligner.setSphere(&sphere);
    aligner.setImage(&odds, nullptr, scene.camera(), scene.width(), scene.height());
    for (std::uint64_t k = 0; k < 64; ++k) {
      poses.push_back(cMo * vpPoseExponential::exp(0.02 * vpPoseRandom(1, {k}).normalTangent()));
      sphere.make(sphere.nearest(poses.back()));
    }
  }

  static vpViewSphereOptions sphereOptions()
  {
    vpViewSphereOptions options;
    options.points = 100;
    return options;
  }

  void learnColors(const BenchScene &scene)
  {
    for (unsigned int i = 0; i < scene.height(); ++i) {
      for (unsigned int j = 0; j < scene.width(); ++j) {
        const int at = depth.index(j, i);
        const bool isObject = at >= 0 && depth.depth[static_cast<std::size_t>(at)] > 0.F;
        const vpRGBa &pixel = scene.colorImage()[i][j];
        histograms.count(static_cast<std::uint32_t>(pixel.R | pixel.G << 8U | pixel.B << 16U),
                         isObject ? vpColorHistograms::OBJECT : vpColorHistograms::BACKGROUND);
      }
    }
    histograms.learn(1.);
  }

  vpHomogeneousMatrix cMo = BenchScene::pose(1);
  vpFrameSource source;
  vpCueFrame frame;
  vpRenderedView depth;
  vpColorHistograms histograms;
  vpColorOddsMap odds;
  vpOrientedDistanceMap edges;
  vpViewSphere sphere;
  vpSurfaceMemory memory;
  vpPoseScore score;
  vpContourAligner aligner;
  std::vector<vpHomogeneousMatrix> poses; // Not all alike: what is near is in the processor's cache.
};

//! The image at half resolution, with the frame that it is made of: its number tells that it is new.
inline void reduceSurfaceFrame(benchmark::State &state, BenchScene &scene)
{
  vpFrameSource source;
  vpSurfaceMemory memory;
  for (auto _ : state) {
    state.PauseTiming();
    const vpCueFrame frame = source.frame(scene.colorImage(), scene.camera(), nullptr);
    state.ResumeTiming();
    memory.setFrame(frame);
  }
}

//! What a trusted frame shows at 500 places; the depth buffer says which of them the object hides.
inline void learnSurface(benchmark::State &state, BenchScene &scene)
{
  SearchScene search(scene);
  for (auto _ : state) {
    search.memory.learn(search.cMo, &search.depth);
  }
}

//! The correlation of a pose with what is remembered at 500 places.
inline void agreeWithSurface(benchmark::State &state, BenchScene &scene)
{
  const SearchScene search(scene);
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(search.memory.agreement(search.poses[k++ % search.poses.size()]).correlation);
  }
}

//! All that tells how well the image shows the object at a pose.
inline void scorePose(benchmark::State &state, BenchScene &scene)
{
  SearchScene search(scene);
  std::size_t k = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(search.score(search.poses[k++ % search.poses.size()]).total);
  }
  state.counters["points"] = static_cast<double>(search.sphere.view(search.sphere.nearest(search.cMo)).size());
}

//! One step of a pose towards the silhouette that separates the colours.
inline void stepSilhouette(benchmark::State &state, BenchScene &scene)
{
  SearchScene search(scene);
  std::vector<Eigen::Isometry3d> poses;
  for (const vpHomogeneousMatrix &cMo : search.poses) {
    poses.push_back(vpPoseExponential::toEigen(cMo));
  }
  std::size_t k = 0;
  for (auto _ : state) {
    Eigen::Isometry3d pose = poses[k++ % poses.size()];
    benchmark::DoNotOptimize(search.aligner.stepByColors(pose, 0.08));
  }
  const vpSphereView &view = search.sphere.view(search.sphere.nearest(search.cMo));
  state.counters["points"] = static_cast<double>(view.silhouettes());
}

} // namespace bench
#endif
