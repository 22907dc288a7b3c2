// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "stripedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/io/vpImageIo.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <thread>

namespace {
double translationError(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm();
}

double rotationError(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return vpMath::deg((truth.inverse() * cMo).getThetaUVector().getTheta());
}

bool isRight(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return translationError(cMo, truth) < 0.003 && rotationError(cMo, truth) < 1.5;
}

bool isSame(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::equal(a.data, a.data + 16, b.data);
}

void prepare(vpMbMultiCueTracker &tracker, bool several)
{
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("hypotheses-box.cao")));
  vpEdgeCueSettings edge = tracker.getEdgeSettings();
  edge.range = 14.;
  edge.candidates = 5;
  tracker.setEdgeSettings(edge);
  vpPoseHypothesisSettings settings;
  settings.enabled = several;
  tracker.setPoseHypothesisSettings(settings);
}

// The start is nearer to the stripe's border than to the right border of the box.
vpHomogeneousMatrix moved(const vpHomogeneousMatrix &cMo, double x)
{
  return vpHomogeneousMatrix(x, 0., 0., 0., 0., 0.) * cMo;
}
} // namespace

TEST_CASE("Beside a stronger parallel neighbour one hypothesis takes the wrong edge, several have the right pose",
          "[hypotheses]")
{
  stripedBox box;
  int wrong = 0;
  int among = 0;
  int best = 0;
  int count = 0;
  for (int i = 0; i < 8; ++i) {
    const vpHomogeneousMatrix truth = stripedBox::frontal(i);
    const vpImage<unsigned char> I = box.draw(truth);
    vpMbMultiCueTracker single, several;
    for (vpMbMultiCueTracker *tracker : {&single, &several}) {
      prepare(*tracker, tracker == &several);
      tracker->initFromPose(I, moved(truth, -0.006)); // 6 pixels.
      tracker->track(I);
    }
    ++count;
    wrong += isRight(single.getPose(), truth) ? 0 : 1;
    best += isRight(several.getPose(), truth) ? 1 : 0;
    const std::vector<vpPoseHypothesis> &found = several.getPoseHypotheses();
    const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(found.size(), 2));
    among += std::any_of(found.begin(), end, [&](const vpPoseHypothesis &h) { return isRight(h.cMo, truth); });
    if (getenv("DBG")) {
      vpImageIo::write(I, "/tmp/hypbench/stripe.png");
      vpFrameSource source;
      vpEdgeCue cue(several.getEdgeSettings());
      vpModelView view(several.getModel());
      view.compute(moved(truth, -0.006), renderedBox::camera(), 640, 480, vpModelViewOptions(), nullptr);
      cue.match(source.frame(I, renderedBox::camera(), nullptr), view);
      vpPoseHypotheses ph;
      const auto &f = ph.find(cue, view, moved(truth, -0.006), 1);
      std::cout << "draws " << ph.differentDraws() << " min " << ph.minimisations() << "\n";
      for (auto &c : ph.contours()) std::cout << "contour " << c.count << " classes " << c.classes << "\n";
      for (auto &h : f) std::cout << " [" << h.residue << " w" << h.weight << " " << translationError(h.cMo, truth) << " " << rotationError(h.cMo, truth) << "]\n";
    }
    std::cout << i << " single " << translationError(single.getPose(), truth) << " " << rotationError(single.getPose(), truth) << " several";
    for (const auto &h : found) std::cout << " [" << h.residue << " w" << h.weight << " " << translationError(h.cMo, truth) << " " << rotationError(h.cMo, truth) << "]";
    std::cout << "\n";
  }
  CHECK(wrong == count);
  CHECK(among == count);
  CHECK(best == count);
}
