// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-compare.cpp
  Runs vpMbMultiCueTracker and ViSP's vpMbGenericTracker(EDGE_TRACKER) side by side on the frames of a recording and
  prints who held the object, how well, and in what time.
*/
#include "evaluate/compareOptions.h"
#include "evaluate/compareReport.h"

#include <modelFiles.h>

#include <visp3/core/vpTime.h>
#include <visp3/io/vpImageIo.h>
#include <visp3/io/vpVideoReader.h>
#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <iostream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
template <typename Tracker> void prepare(Tracker &tracker, const compareOptions &options)
{
  tracker.loadConfigFile(options.config, false);
  tracker.loadModel(options.model);
  for (const compareOptions::Part &part : options.parts) {
    tracker.loadModel(part.file, false, part.oMp);
  }
}

template <typename Tracker>
void start(Tracker &tracker, const vpImage<unsigned char> &I, const compareOptions &options, int frame)
{
  if (!options.truth.empty()) {
    tracker.initFromPose(I, options.truthAt(frame));
  } else if (!options.initPoints.empty()) {
    tracker.initFromPoints(I, options.initPoints, options.initPoints3d);
  } else {
    tracker.initFromPose(I, options.initPose);
  }
}

// One tracker over all frames. ViSP's gives up by throwing; from then on its frames count as lost.
template <typename Tracker, typename Held>
compareRun run(Tracker &tracker, vpMbGenericTracker &judge, const compareOptions &options, const Held &held)
{
  compareRun result;
  vpVideoReader reader;
  options.open(reader);
  vpImage<unsigned char> I;
  vpCameraParameters cam;
  tracker.getCameraParameters(cam);
  bool alive = true;
  for (int frame = options.first; frame <= options.last && !reader.end(); ++frame) {
    reader.acquire(I);
    if (frame == options.first) {
      start(tracker, I, options, frame);
    }
    compareFrame outcome;
    const double begin = vpTime::measureTimeMs();
    try {
      if (alive) {
        tracker.track(I);
      }
    } catch (const vpException &e) {
      std::cout << "frame " << frame << ": " << e.getMessage() << std::endl;
      alive = false;
    }
    outcome.ms = vpTime::measureTimeMs() - begin;
    outcome.held = alive && held(tracker);
    vpHomogeneousMatrix cMo;
    tracker.getPose(cMo);
    outcome.projectionError = judge.computeCurrentProjectionError(I, cMo, cam);
    if (!options.truth.empty()) {
      outcome.compare(cMo, options.truthAt(frame));
    }
    result.frames.push_back(outcome);
    result.poses.push_back(cMo);
  }
  return result;
}
} // namespace

int main(int argc, const char *argv[])
{
  try {
    compareOptions options;
    if (!options.read(argc, argv)) {
      return 0;
    }
    const int type = vpMbGenericTracker::EDGE_TRACKER | (options.points ? vpMbGenericTracker::KLT_TRACKER : 0);
    vpMbGenericTracker visp(1, type);
    prepare(visp, options);
    if (options.oldScaleThreshold > 0.) {
      // For files whose threshold is in gray levels, which ViSP 3.5 reads in its old scale.
      vpMe me = visp.getMovingEdge();
      me.setThreshold(options.oldScaleThreshold);
      visp.setMovingEdge(me);
    }
    visp.setScanLineVisibilityTest(options.scanline);

    vpMbMultiCueTracker ours(1, type);
    ours.setModelUnit(options.unit);
    compareOptions ourOptions = options;
    if (!options.mesh.empty()) {
      ourOptions.model = options.mesh;
    }
    prepare(ours, ourOptions);
    vpEdgeCueSettings edge = ours.getEdgeSettings();
    edge.candidates = options.candidates;
    ours.setEdgeSettings(edge);
    vpPoseHypothesisSettings hypotheses = ours.getPoseHypothesisSettings();
    hypotheses.enabled = options.hypotheses;
    ours.setPoseHypothesisSettings(hypotheses);
    double minimisations = 0.;
    double frames = 0.;
    std::cout << ours.getModelReport();
    if (!options.writeMesh.empty()) {
      writeModelAsObj(*ours.getModel(), options.writeMesh);
    }

    // A tracker of its own measures the projection error of both, with ViSP's own code.
    vpMbGenericTracker judge(1, vpMbGenericTracker::EDGE_TRACKER);
    prepare(judge, options);

    compareReport report(std::cout);
    for (int i = 0; i < options.repeat; ++i) {
      const compareRun theirs = run(visp, judge, options, [](vpMbGenericTracker &) { return true; });
      const compareRun mine = run(ours, judge, options, [&](vpMbMultiCueTracker &tracker) {
        minimisations += tracker.getNbPoseMinimisations();
        ++frames;
        return tracker.getTrackingState() == vpTrackingState::TRACKING;
      });
      report.add("visp", theirs);
      report.add("multicue", mine);
      if (i == 0 && !options.poses.empty()) {
        report.writePoses(options.poses, mine);
      }
    }
    report.print(!options.truth.empty());
    if (options.hypotheses) {
      std::cout << "minimisations per frame, mean: " << minimisations / frames << std::endl;
    }
  } catch (const std::exception &e) {
    std::cerr << e.what() << std::endl;
    return 1;
  }
  return 0;
}
