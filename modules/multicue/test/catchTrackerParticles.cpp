// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "stripedBox.h"

#include <meshFiles.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace {
bool isSame(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::equal(a.data, a.data + 16, b.data);
}

double distance(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return (a.getTranslationVector() - b.getTranslationVector()).frobeniusNorm();
}

void prepare(vpMbMultiCueTracker &tracker, unsigned int seed = 1)
{
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("particles-box.cao")));
  vpEdgeCueSettings edge = tracker.getEdgeSettings();
  edge.range = 14.;
  edge.candidates = 5;
  tracker.setEdgeSettings(edge);
  vpPoseHypothesisSettings hypotheses;
  hypotheses.enabled = true;
  tracker.setPoseHypothesisSettings(hypotheses);
  vpParticleSettings settings;
  settings.enabled = true;
  settings.seed = seed;
  tracker.setParticleSettings(settings);
}

vpHomogeneousMatrix shifted(const vpHomogeneousMatrix &cMo, double x)
{
  return vpHomogeneousMatrix(x, 0., 0., 0., 0., 0.) * cMo;
}

double totalWeight(const std::vector<vpPoseParticle> &particles)
{
  double sum = 0.;
  for (const vpPoseParticle &particle : particles) {
    sum += particle.weight;
  }
  return sum;
}

std::string refusal(const std::function<void(vpParticleSettings &)> &change)
{
  vpParticleSettings settings;
  change(settings);
  try {
    settings.check();
  } catch (const vpException &error) {
    return error.what();
  }
  return "";
}
} // namespace

TEST_CASE("Settings out of range are named, and the old ones stay", "[particles]")
{
  CHECK_NOTHROW(vpParticleSettings().check());
  using Settings = vpParticleSettings;
  CHECK_THAT(refusal([](Settings &s) { s.number = 9; }), ContainsSubstring("vpParticleSettings::number is 9"));
  CHECK_THAT(refusal([](Settings &s) { s.leastNumber = 500; }), ContainsSubstring("mostNumber is 300"));
  CHECK_THAT(refusal([](Settings &s) { s.budget = -1.; }), ContainsSubstring("budget"));
  CHECK_THAT(refusal([](Settings &s) { s.translationNoise = 0.; }), ContainsSubstring("translationNoise"));
  CHECK_THAT(refusal([](Settings &s) { s.rotationNoise = std::nan(""); }), ContainsSubstring("rotationNoise"));
  CHECK_THAT(refusal([](Settings &s) { s.motionNoise = -0.1; }), ContainsSubstring("motionNoise"));
  CHECK_THAT(refusal([](Settings &s) { s.jumpShare = 1.; }), ContainsSubstring("jumpShare"));
  CHECK_THAT(refusal([](Settings &s) { s.jumpFactor = 0.5; }), ContainsSubstring("jumpFactor"));
  CHECK_THAT(refusal([](Settings &s) { s.lambda = -1.; }), ContainsSubstring("lambda"));
  CHECK_THAT(refusal([](Settings &s) { s.sharpness = HUGE_VAL; }), ContainsSubstring("sharpness"));
  CHECK_THAT(refusal([](Settings &s) { s.bestShare = 1.1; }), ContainsSubstring("bestShare"));
  CHECK_THAT(refusal([](Settings &s) { s.mostOptimised = 101; }), ContainsSubstring("mostOptimised"));
  CHECK_THAT(refusal([](Settings &s) { s.modeTranslation = 0.; }), ContainsSubstring("modeTranslation"));
  CHECK_THAT(refusal([](Settings &s) { s.modeRotation = 4.; }), ContainsSubstring("modeRotation"));

  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  vpParticleSettings good;
  good.number = 50;
  tracker.setParticleSettings(good);
  vpParticleSettings bad = good;
  bad.number = 60;
  bad.lambda = -1.;
  CHECK_THROWS_AS(tracker.setParticleSettings(bad), vpException);
  CHECK(tracker.getParticleSettings().number == 50);
}

TEST_CASE("Particles follow a box, as many as asked for, with weights that add up to one", "[particles]")
{
  stripedBox box;
  const vpHomogeneousMatrix truth = stripedBox::frontal(0);
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker);
  CHECK(tracker.getParticles().empty());
  tracker.initFromPose(box.draw(truth), truth);
  for (int i = 1; i <= 6; ++i) {
    tracker.track(box.draw(shifted(truth, 0.003 * i)));
    const std::vector<vpPoseParticle> particles = tracker.getParticles();
    CHECK(particles.size() >= 100);
    CHECK(particles.size() <= 200);
    CHECK(totalWeight(particles) == Approx(1.));
    REQUIRE(!tracker.getPoseModes().empty());
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK(distance(tracker.getPose(), shifted(truth, 0.003 * i)) < 0.004);
    CHECK(distance(tracker.getParticleMean(), shifted(truth, 0.003 * i)) < 0.02);
  }
  CHECK(tracker.getTimings().particles > 0.);
  CHECK(tracker.getTimings().map > 0.);
  tracker.setPose(box.draw(truth), truth); // They begin anew.
  CHECK(tracker.getParticles().empty());
}

TEST_CASE("The same seed gives the same bits, another one other particles", "[particles]")
{
  stripedBox box;
  const vpHomogeneousMatrix truth = stripedBox::frontal(0);
  vpMbMultiCueTracker a(vpMbMultiCueTracker::EDGE_TRACKER), b(vpMbMultiCueTracker::EDGE_TRACKER),
      other(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(a);
  prepare(b);
  prepare(other, 2);
  for (vpMbMultiCueTracker *tracker : {&a, &b, &other}) {
    tracker->initFromPose(box.draw(truth), truth);
    for (int i = 1; i <= 3; ++i) {
      tracker->track(box.draw(shifted(truth, 0.004 * i)));
    }
  }
  CHECK(isSame(a.getPose(), b.getPose()));
  const std::vector<vpPoseParticle> first = a.getParticles();
  const std::vector<vpPoseParticle> second = b.getParticles();
  REQUIRE(first.size() == second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(isSame(first[i].cMo, second[i].cMo));
    CHECK(first[i].weight == exactly(second[i].weight));
  }
  CHECK_FALSE(isSame(first.front().cMo, other.getParticles().front().cMo));
}

TEST_CASE("Two poses that the image allows are two modes with a mass each", "[particles]")
{
  stripedBox box;
  const vpHomogeneousMatrix truth = stripedBox::frontal(0);
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker);
  vpParticleSettings settings = tracker.getParticleSettings();
  settings.lambda = 5.; // Not yet decided.
  settings.modeTranslation = 0.03;
  settings.modeRotation = 0.06;
  tracker.setParticleSettings(settings);
  const vpImage<unsigned char> I = box.draw(truth);
  tracker.initFromPose(I, shifted(truth, -0.006));
  int several = 0;
  for (int i = 0; i < 4; ++i) {
    tracker.track(I);
    const std::vector<vpPoseMode> modes = tracker.getPoseModes();
    double sum = 0.;
    for (std::size_t k = 0; k < modes.size(); ++k) {
      CHECK(modes[k].mass > 0.);
      CHECK((k == 0 || modes[k].mass <= modes[k - 1].mass));
      sum += modes[k].mass;
    }
    CHECK(sum <= 1. + 1e-9);
    several += modes.size() > 1 ? 1 : 0;
  }
  CHECK(several >= 2);
}

TEST_CASE("An image that shows nothing stops no particle", "[particles]")
{
  stripedBox box;
  const vpHomogeneousMatrix truth = stripedBox::frontal(0);
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker);
  const vpImage<unsigned char> I = box.draw(truth);
  tracker.initFromPose(I, truth);
  tracker.track(I);
  const vpImage<unsigned char> nothing(I.getHeight(), I.getWidth(), 90);
  for (int i = 0; i < 5; ++i) {
    CHECK_NOTHROW(tracker.track(nothing));
    CHECK(tracker.getTrackingState() == vpTrackingState::LOST);
    CHECK(totalWeight(tracker.getParticles()) == Approx(1.));
  }
  tracker.track(I);
  CHECK(distance(tracker.getPose(), truth) < 0.01);
}

TEST_CASE("With several cues particles follow, and the pose is the one without them", "[particles]")
{
  stripedBox box;
  const vpHomogeneousMatrix truth = stripedBox::frontal(0);
  vpMbMultiCueTracker with, without;
  for (vpMbMultiCueTracker *tracker : {&with, &without}) {
    prepare(*tracker);
    tracker->setTrackerType(vpMbMultiCueTracker::EDGE_TRACKER | vpMbMultiCueTracker::COLOR_TRACKER);
  }
  vpParticleSettings off;
  without.setParticleSettings(off);
  for (vpMbMultiCueTracker *tracker : {&with, &without}) {
    tracker->initFromPose(box.draw(truth), truth);
    for (int i = 1; i <= 4; ++i) {
      tracker->track(box.draw(shifted(truth, 0.003 * i)));
    }
  }
  CHECK(isSame(with.getPose(), without.getPose()));
  CHECK(with.getParticles().size() == 101);
  CHECK(without.getParticles().empty());
  CHECK(distance(with.getParticleMean(), with.getPose()) < 0.02);
}
