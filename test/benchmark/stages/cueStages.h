// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchCueStages_h
#define benchCueStages_h

#include "stages/benchScene.h"

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpRobust.h>
#include <visp3/cues/vpColorCue.h>
#include <visp3/cues/vpColorOddsMap.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/cues/vpOrientedDistanceMap.h>
#include <visp3/cues/vpPointCue.h>

#include <benchmark/benchmark.h>

/*!
  \file cueStages.h
  The image's side of a frame, and the equations that come of both.
*/

namespace bench {

//! What all cues share of a gray image.
inline void frameOfGray(benchmark::State &state, BenchScene &scene)
{
  vpFrameSource source;
  int k = 0;
  for (auto _ : state) {
    const vpCueFrame frame = source.frame(scene.image(k++), scene.camera(), nullptr);
    const unsigned char *pixels = frame.gray().bitmap;
    benchmark::DoNotOptimize(pixels);
  }
}

//! Likewise of an image in colour.
inline void frameOfColor(benchmark::State &state, BenchScene &scene)
{
  vpFrameSource source;
  for (auto _ : state) {
    const vpCueFrame frame = source.frame(scene.colorImage(), scene.camera(), nullptr);
    const unsigned char *pixels = frame.gray().bitmap;
    benchmark::DoNotOptimize(pixels);
  }
}

//! Likewise of a gray image with the distortion of a lens.
inline void frameOfDistorted(benchmark::State &state, BenchScene &scene)
{
  vpFrameSource source;
  int k = 0;
  for (auto _ : state) {
    const vpCueFrame frame = source.frame(scene.image(k++), scene.distortedCamera(), nullptr);
    const unsigned char *pixels = frame.gray().bitmap;
    benchmark::DoNotOptimize(pixels);
  }
}

inline vpImageRegion wholeImage(const vpCueFrame &frame)
{
  return vpImageRegion(0, 0, static_cast<int>(frame.width()), static_cast<int>(frame.height()));
}

//! The oriented distance map of a whole image.
inline void mapDistances(benchmark::State &state, BenchScene &scene)
{
  vpFrameSource source;
  vpOrientedDistanceMap map;
  int k = 0;
  for (auto _ : state) {
    const vpCueFrame frame = source.frame(scene.image(k++), scene.camera(), nullptr);
    map.compute(frame, wholeImage(frame));
    benchmark::DoNotOptimize(map.distance(1., 1., 0));
  }
  state.counters["edges"] = static_cast<double>(map.edgeCount());
}

//! The map of the colours' log-odds of a whole image.
inline void mapColorOdds(benchmark::State &state, BenchScene &scene)
{
  vpFrameSource source;
  const vpCueFrame frame = source.frame(scene.colorImage(), scene.camera(), nullptr);
  vpColorHistograms histograms;
  for (unsigned int k = 0; k < 0x1000000U; k += 0x1003U) {
    histograms.count(k, k % 3 == 0 ? vpColorHistograms::OBJECT : vpColorHistograms::BACKGROUND);
  }
  histograms.learn(1.);
  vpColorOddsMap map;
  for (auto _ : state) {
    map.compute(frame, histograms, wholeImage(frame));
    benchmark::DoNotOptimize(map.logOdds(1., 1.));
  }
}

//! An edge cue that knows image 0 and looks for its view in image 1.
struct EdgeMatch
{
  explicit EdgeMatch(BenchScene &scene) : view(scene.model()), cue(scene.tracker().getEdgeSettings())
  {
    vpCpuRenderer renderer(scene.model());
    view.compute(cMo, scene.camera(), scene.width(), scene.height(), scene.viewOptions(), &renderer);
    cue.match(source.frame(scene.image(0), scene.camera(), nullptr), view);
    vpResidualBlock block;
    cue.residuals(cMo, block);
    cue.updateReference(cMo, std::vector<double>(block.rows.size(), 1.));
    frame = source.frame(scene.image(1), scene.camera(), nullptr);
    cue.match(frame, view);
  }

  vpHomogeneousMatrix cMo = BenchScene::pose(0);
  vpFrameSource source;
  vpCueFrame frame;
  vpModelView view;
  vpEdgeCue cue;
};

//! The edges of an image along the normals of all control points.
inline void matchEdges(benchmark::State &state, BenchScene &scene)
{
  EdgeMatch match(scene);
  for (auto _ : state) {
    match.cue.match(match.frame, match.view);
  }
  state.counters["points"] = static_cast<double>(match.view.points().size());
}

//! A colour cue that knows the image at its pose.
struct ColorMatch
{
  explicit ColorMatch(BenchScene &scene) : view(scene.model())
  {
    vpCpuRenderer renderer(scene.model());
    vpModelViewOptions options = scene.viewOptions();
    options.sampleStep = 3.;
    view.compute(cMo, scene.camera(), scene.width(), scene.height(), options, &renderer);
    vpColorCueSettings settings;
    settings.spacing = 3.;
    cue.setSettings(settings);
    frame = source.frame(scene.colorImage(), scene.camera(), nullptr);
    cue.match(frame, view);
    cue.residuals(cMo, block);
    cue.updateReference(cMo, std::vector<double>(block.rows.size(), 1.));
  }

  vpHomogeneousMatrix cMo = BenchScene::pose(1);
  vpFrameSource source;
  vpCueFrame frame;
  vpModelView view;
  vpColorCue cue;
  vpResidualBlock block;
};

//! The finest level: statistics and samples of all lines, and the rows of three iterations.
inline void matchColor(benchmark::State &state, BenchScene &scene)
{
  ColorMatch match(scene);
  for (auto _ : state) {
    match.cue.match(match.frame, match.view);
    for (int k = 0; k < 3; ++k) {
      match.cue.residuals(match.cMo, match.block);
    }
  }
  state.counters["lines"] = static_cast<double>(match.cue.lines().size());
}

//! All levels, each with its match and the rows of three iterations.
inline void matchColorLevels(benchmark::State &state, BenchScene &scene)
{
  ColorMatch match(scene);
  for (auto _ : state) {
    for (unsigned int level = 0; level < match.cue.levels(); ++level) {
      match.cue.setLevel(level);
      match.cue.match(match.frame, match.view);
      for (int k = 0; k < 3; ++k) {
        match.cue.residuals(match.cMo, match.block);
      }
    }
  }
  state.counters["levels"] = match.cue.levels();
  state.counters["lines"] = static_cast<double>(match.cue.lines().size());
}

//! A point cue that made its points in image 0 and looks for them in image 1. The model gets a pattern: the scene's own
//! images have plain sides.
struct PointMatch
{
  explicit PointMatch(BenchScene &scene) : view(scene.model()), renderer(scene.model())
  {
    cue.setDepthSource([&](const vpHomogeneousMatrix &pose) {
      renderer.render(pose, scene.camera(), scene.width(), scene.height(), vpRenderOptions(), depth);
      return &depth;
    });
    view.compute(cMo, scene.camera(), scene.width(), scene.height(), scene.viewOptions(), &renderer);
    DrawnImages drawn(scene.model(), DrawnImages::Surface::MARBLE);
    first = drawn.draw(cMo, scene.camera(), scene.width(), scene.height());
    second = drawn.draw(BenchScene::pose(1), scene.camera(), scene.width(), scene.height());
    cue.match(source.frame(first, scene.camera(), nullptr), view);
    cue.updateReference(cMo, {});
  }

  vpHomogeneousMatrix cMo = BenchScene::pose(0);
  vpFrameSource source;
  vpImage<unsigned char> first, second;
  vpModelView view;
  vpCpuRenderer renderer;
  vpRenderedView depth;
  vpPointCue cue;
};

//! A new image's pyramid, and the points in it: there, back, and aligned.
inline void matchPoints(benchmark::State &state, BenchScene &scene)
{
  if (!vpPointCue::isAvailable()) {
    state.SkipWithError("this build has no point cue");
    return;
  }
  PointMatch match(scene);
  std::size_t found = 0;
  for (auto _ : state) {
    match.cue.match(match.source.frame(match.second, scene.camera(), nullptr), match.view);
  }
  for (const vpPointCue::Match &point : match.cue.matches()) {
    found += point.found ? 1 : 0;
  }
  if (2 * found < match.cue.pointCount() || found == 0) {
    failBenchmark(state, "most points were lost");
  }
  state.counters["points"] = static_cast<double>(match.cue.pointCount());
  state.counters["found"] = static_cast<double>(found);
}

/*!
  One iteration of virtual visual servoing in the steps of vpMbMultiCueTracker, of whose base class it borrows the
  functions: they are protected.
*/
class VvsIteration : public vpMbMultiCueTracker
{
public:
  //! \return The pose after the iteration.
  vpHomogeneousMatrix step(const vpEdgeCue &cue, const vpHomogeneousMatrix &cMo)
  {
    cue.residuals(cMo, m_block);
    const unsigned int rows = static_cast<unsigned int>(m_block.rows.size());
    m_rowsL.resize(rows, 6, false, false);
    m_rowsError.resize(rows, false);
    m_rowsWeight.resize(rows, false);
    m_weighted.resize(rows, false);
    fill();
    m_robust.setMinMedianAbsoluteDeviation(m_block.noise);
    computeVVSWeights(m_robust, m_rowsError, m_rowsWeight);
    weigh();
    computeVVSPoseEstimation(true, 0, m_rowsL, m_LTL, m_weighted, m_rowsError, m_errorBefore, m_LTR, m_mu, m_velocity);
    return vpExponentialMap::direct(m_velocity).inverse() * cMo;
  }
  unsigned int rows() const { return m_rowsError.getRows(); }

private:
  void fill()
  {
    for (unsigned int i = 0; i < m_rowsError.getRows(); ++i) {
      m_rowsError[i] = m_block.rows[i].error;
      for (unsigned int j = 0; j < 6; ++j) {
        m_rowsL[i][j] = m_block.rows[i].jacobian[j];
      }
    }
  }
  void weigh()
  {
    for (unsigned int i = 0; i < m_rowsError.getRows(); ++i) {
      const double w = m_rowsWeight[i] * m_block.rows[i].weight;
      m_weighted[i] = w * m_rowsError[i];
      for (unsigned int j = 0; j < 6; ++j) {
        m_rowsL[i][j] *= w;
      }
    }
  }

  vpResidualBlock m_block;
  vpRobust m_robust;
  vpMatrix m_rowsL, m_LTL;
  vpColVector m_rowsError, m_rowsWeight, m_weighted, m_errorBefore, m_LTR, m_velocity;
  double m_mu = 0.01;
};

//! Residuals, robust weights, normal equations and their solution.
inline void iterateVvs(benchmark::State &state, BenchScene &scene)
{
  const EdgeMatch match(scene);
  VvsIteration iteration;
  for (auto _ : state) {
    const vpHomogeneousMatrix cMo = iteration.step(match.cue, match.cMo);
    const double *numbers = cMo.data;
    benchmark::DoNotOptimize(numbers);
  }
  state.counters["rows"] = iteration.rows();
}

} // namespace bench
#endif
