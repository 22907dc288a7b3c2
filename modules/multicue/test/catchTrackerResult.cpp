// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "renderedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {
using Reason = vpMbTrackingResult::Reason;
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int klt = vpMbMultiCueTracker::KLT_TRACKER;
const int color = vpMbMultiCueTracker::COLOR_TRACKER;

void prepare(vpMbMultiCueTracker &tracker, int type)
{
  tracker.setTrackerType(type);
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("box.cao")));
}

vpImage<vpRGBa> uniform()
{
  return vpImage<vpRGBa>(renderedBox::height, renderedBox::width, vpRGBa(90, 90, 90));
}

bool same(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::equal(a.data, a.data + 16, b.data);
}

bool same(const vpTrackingTimings &a, const vpTrackingTimings &b)
{
  return a.frame == exactly(b.frame) && a.view == exactly(b.view) && a.match == exactly(b.match) &&
         a.pose == exactly(b.pose) && a.map == exactly(b.map) && a.particles == exactly(b.particles) &&
         a.total == exactly(b.total);
}

bool same(const vpPoseHypothesis &a, const vpPoseHypothesis &b)
{
  return same(a.cMo, b.cMo) && a.residue == exactly(b.residue) && a.weight == exactly(b.weight);
}

// What testTracking() throws; empty where it does not.
std::string lossText(vpMbMultiCueTracker &tracker)
{
  try {
    tracker.testTracking();
  } catch (const vpException &e) {
    return e.getMessage();
  }
  return "";
}

// What holds whatever the image shows.
void checkAgainstGetters(vpMbMultiCueTracker &tracker, const vpMbTrackingResult &result)
{
  CHECK(same(result.cMo, tracker.getPose()));
  CHECK(result.state == tracker.getTrackingState());
  CHECK(result.score >= 0.);
  CHECK(result.score <= 1.);
  CHECK_FALSE(result.text.empty());
  CHECK(same(result.timings, tracker.getTimings()));
  const std::vector<vpPoseHypothesis> &hypotheses = tracker.getPoseHypotheses();
  CHECK(std::equal(result.hypotheses.begin(), result.hypotheses.end(), hypotheses.begin(), hypotheses.end(),
                   [](const vpPoseHypothesis &a, const vpPoseHypothesis &b) { return same(a, b); }));
  if (result.covariance.size() > 0) {
    const vpMatrix covariance = tracker.getCovarianceMatrix();
    CHECK(std::equal(result.covariance.data, result.covariance.data + 36, covariance.data));
  }
  const std::string loss = lossText(tracker);
  CHECK(loss.empty() == (result.state != vpTrackingState::LOST));
  CHECK((loss.empty() || ("The object is lost: " + result.text).find(loss) == 0));

  unsigned int expected = 0;
  unsigned int good = 0;
  int types = 0;
  for (const vpMbTrackingResult::Cue &cue : result.cues) {
    CHECK(cue.reason == tracker.getCueReason(cue.type));
    CHECK_FALSE(cue.agreement < 0.);
    CHECK(cue.good <= cue.expected);
    CHECK((cue.type != edge || cue.good == tracker.getNbPoints()));
    types |= cue.type;
    expected += cue.expected;
    good += cue.good;
  }
  CHECK(types == tracker.getTrackerType());
  CHECK((expected == 0 ? 0. : static_cast<double>(good) / expected) == exactly(tracker.getSupport()));
}
} // namespace

TEST_CASE("A result says that there is none before an image was tracked", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker(1, edge | klt | color);
  checkAgainstGetters(tracker, tracker.getTrackingResult());
  prepare(tracker, edge | klt | color);
  CHECK(tracker.getTrackingResult().text == "no initial pose was given");
  const vpImage<vpRGBa> I = box.drawColor(renderedBox::pose());
  for (int start = 0; start < 2; ++start) {
    tracker.initFromPose(I, renderedBox::pose());
    const vpMbTrackingResult result = tracker.getTrackingResult();
    checkAgainstGetters(tracker, result);
    CHECK(result.reason == Reason::NOT_STARTED);
    CHECK(result.text == "no image was tracked yet");
    CHECK(result.score == exactly(0.));
    tracker.track(I); // What it leaves behind is forgotten by the next start.
    CHECK(tracker.getTrackingResult().score > 0.);
  }
}

TEST_CASE("A result is what the single getters say of a frame", "[tracker]")
{
  renderedBox box;
  const vpImage<vpRGBa> I = box.drawColor(renderedBox::pose());
  for (const int type : {edge, color, klt, edge | klt | color}) {
    vpMbMultiCueTracker tracker;
    prepare(tracker, type);
    vpPoseHypothesisSettings settings;
    settings.enabled = true;
    tracker.setPoseHypothesisSettings(settings);
    tracker.initFromPose(I, renderedBox::pose());
    tracker.track(I);
    CHECK(tracker.getTrackingResult().covariance.size() == 0);
    tracker.setCovarianceComputation(true);
    tracker.track(I);

    INFO("type " << type);
    const vpMbTrackingResult result = tracker.getTrackingResult();
    checkAgainstGetters(tracker, result);
    REQUIRE(result.covariance.size() == 36);
    CHECK(result.covariance[4][4] > 0.);
    CHECK(result.timings.match > 0.);
    CHECK(result.timings.total > result.timings.match);
    if (type == klt) {
      continue; // The box has hardly any texture.
    }
    CHECK(result.reason == Reason::WELL_EXPLAINED);
    CHECK(result.score > 0.7);
    CHECK(result.hypotheses.empty() == (type != edge));
    for (const vpMbTrackingResult::Cue &cue : result.cues) {
      CHECK(cue.name == (cue.type == edge ? "edge" : cue.type == color ? "color" : "point"));
      if (cue.type == edge) {
        CHECK(cue.good == tracker.getNbFeaturesEdge());
      }
      CHECK(std::isnan(cue.agreement) == (cue.type == klt));
      if (!std::isnan(cue.agreement)) {
        CHECK(cue.agreement > 0.6);
      }
    }
  }
}

TEST_CASE("A result tells why an image without the object is not believed", "[tracker]")
{
  renderedBox box;
  const vpImage<vpRGBa> I = box.drawColor(renderedBox::pose());
  for (const bool predicts : {false, true}) {
    for (const int type : {edge, color, edge | klt | color}) {
      for (const bool isKnown : {false, true}) {
        CAPTURE(predicts, type, isKnown);
        vpMbMultiCueTracker tracker;
        prepare(tracker, type);
        tracker.setPrediction(predicts);
        tracker.initFromPose(I, renderedBox::pose());
        if (isKnown) {
          tracker.track(I);
          REQUIRE(tracker.getTrackingResult().reason == Reason::WELL_EXPLAINED);
        }
        tracker.track(uniform());
        const vpMbTrackingResult result = tracker.getTrackingResult();
        checkAgainstGetters(tracker, result);
        CAPTURE(result.text, result.score);
        REQUIRE(result.state == vpTrackingState::LOST);
        CHECK(result.score == exactly(0.));
        const bool coasts = predicts && isKnown;
        const Reason seen = type == edge ? Reason::NOTHING_SEEN : Reason::CONTRADICTED;
        CHECK(toString(result.reason) == std::string(toString(coasts ? Reason::COASTING : seen)));
        CHECK((result.text.find("predicted") != std::string::npos) == coasts);
      }
    }
  }
}

TEST_CASE("Reasons have the names of the header", "[tracker]")
{
  CHECK(std::string(toString(Reason::NOT_STARTED)) == "NOT_STARTED");
  CHECK(std::string(toString(Reason::FEW_FEATURES)) == "FEW_FEATURES");
  CHECK(std::string(toString(Reason::COASTING)) == "COASTING");
}
