// SPDX-License-Identifier: GPL-2.0-or-later
// Scores of any pose, and results that are saved.
#include <catchMain.h>

#include "renderedBox.h"
#include "settingsFiles.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <cmath>
#include <limits>

namespace {
using settingsFiles::messageOf;
using Folder = settingsFiles::Folder;

vpHomogeneousMatrix poseAt(int i)
{
  return renderedBox::pose() * vpHomogeneousMatrix(0.002 * i, 0., 0.001 * i, 0., 0.01 * i, 0.);
}

void prepare(vpMbMultiCueTracker &tracker)
{
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("score-box.cao")));
  tracker.setFrameDeadline(0.); // Time would decide otherwise.
}

// As far off the pose as the image has pixels, in one of several directions.
vpHomogeneousMatrix off(double pixels, int direction)
{
  const double metres = pixels * renderedBox::pose()[2][3] / renderedBox::camera().get_px();
  const vpHomogeneousMatrix shifts[] = {vpHomogeneousMatrix(metres, 0., 0., 0., 0., 0.),
                                        vpHomogeneousMatrix(0., metres, 0., 0., 0., 0.),
                                        vpHomogeneousMatrix(-metres, metres, 0., 0., 0., 0.)};
  return shifts[direction] * renderedBox::pose();
}
} // namespace

TEST_CASE("A right pose has a high score, a wrong one a low score, in gray and in colour", "[score]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker);
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  vpImage<vpRGBa> color(I.getHeight(), I.getWidth());
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    color.bitmap[k] = vpRGBa(I.bitmap[k], I.bitmap[k], I.bitmap[k]);
  }
  CHECK(tracker.score(I, renderedBox::pose()) > 0.95);
  CHECK(tracker.score(color, renderedBox::pose()) > 0.95);
  for (int direction = 0; direction < 3; ++direction) {
    CHECK(tracker.score(I, off(0.5, direction)) > 0.9);
    CHECK(tracker.score(I, off(15., direction)) < 0.2);
    CHECK(tracker.score(color, off(40., direction)) < 0.2);
  }
  const vpImage<unsigned char> nothing(I.getHeight(), I.getWidth(), 90);
  CHECK(tracker.score(nothing, renderedBox::pose()) < 0.1);
}

TEST_CASE("A score changes nothing of what is tracked", "[score]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker, scored;
  for (vpMbMultiCueTracker *one : {&tracker, &scored}) {
    prepare(*one);
    one->initFromPose(box.draw(poseAt(0)), poseAt(0));
  }
  for (int i = 1; i < 8; ++i) {
    const vpImage<unsigned char> I = box.draw(poseAt(i));
    CHECK(scored.score(I, poseAt(i)) > 0.9);
    const double far = scored.score(I, off(60., 0));
    scored.score(vpImage<unsigned char>(100, 120, 7), poseAt(i)); // Of another size.
    tracker.track(I);
    scored.track(I);
    CHECK(far < 0.3);
    const vpHomogeneousMatrix cMo = tracker.getPose();
    const vpHomogeneousMatrix scoredPose = scored.getPose();
    CHECK(std::equal(cMo.data, cMo.data + 16, scoredPose.data, vpIsSame));
    CHECK(vpIsSame(tracker.getTrackingResult().score, scored.getTrackingResult().score));
    CHECK(scored.score(I, scoredPose) > 0.9); // With what it learnt.
    CHECK(vpIsSame(scored.score(I, poseAt(0)), scored.score(I, poseAt(0))));
  }
}

TEST_CASE("A pose that no camera sees has no score, and one that is none is refused", "[score]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  CHECK_THAT(messageOf([&] { tracker.score(I, renderedBox::pose()); }), ContainsSubstring("model"));
  prepare(tracker);
  CHECK(vpIsSame(tracker.score(I, vpHomogeneousMatrix(0., 0., -1., 0., 0., 0.)), 0.));
  CHECK(vpIsSame(tracker.score(I, vpHomogeneousMatrix(50., 0., 1., 0., 0., 0.)), 0.));
  vpHomogeneousMatrix broken = renderedBox::pose();
  broken[0][0] = std::nan("");
  CHECK_FALSE(messageOf([&] { tracker.score(I, broken); }).empty());
  CHECK_THAT(messageOf([&] { tracker.score(vpImage<unsigned char>(), renderedBox::pose()); }),
             ContainsSubstring("empty"));
}

TEST_CASE("A result is read as it was written, to the last digit", "[result]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker;
  prepare(tracker);
  tracker.setCovarianceComputation(true);
  vpPoseHypothesisSettings hypotheses;
  hypotheses.enabled = true;
  tracker.setPoseHypothesisSettings(hypotheses);
  tracker.initFromPose(box.draw(poseAt(0)), poseAt(0));
  tracker.track(box.draw(poseAt(1)));
  vpMbTrackingResult result = tracker.getTrackingResult();
  result.unobserved.push_back({vpColVector(6, 1. / 3.), "turn about \"x\""});
  vpPoseHypothesis hypothesis;
  hypothesis.cMo = poseAt(3);
  hypothesis.residue = 1. / 7.;
  hypothesis.classes = {1, -1, 0};
  result.hypotheses.push_back(hypothesis);
  REQUIRE(result.cues.size() > 1);
  result.cues[1].agreement = std::numeric_limits<double>::quiet_NaN();

  const Folder folder;
  result.saveToFile(folder.path("result.json"));
  const vpMbTrackingResult read = vpMbTrackingResult::readFromJsonFile(folder.path("result.json"));
  CHECK(std::equal(result.cMo.data, result.cMo.data + 16, read.cMo.data, vpIsSame));
  CHECK(std::equal(result.covariance.data, result.covariance.data + 36, read.covariance.data, vpIsSame));
  CHECK(read.state == result.state);
  CHECK(read.reason == result.reason);
  CHECK(read.text == result.text);
  CHECK(std::isnan(read.cues[1].agreement));
  CHECK(read.cues[0].good == result.cues[0].good);
  CHECK(read.unobserved.back().text == "turn about \"x\"");
  CHECK(vpIsSame(read.unobserved.back().direction[5], 1. / 3.));
  CHECK(read.hypotheses.back().classes == hypothesis.classes);
  CHECK(read.toJson() == result.toJson());
  CHECK(result.toJson().find('\n') == std::string::npos);
  // A result that no frame was tracked for.
  const vpMbTrackingResult fresh = vpMbMultiCueTracker().getTrackingResult();
  CHECK(vpMbTrackingResult::fromJson(fresh.toJson()).toJson() == fresh.toJson());
}

TEST_CASE("A result that is broken is refused by the member", "[result]")
{
  const std::string good = vpMbTrackingResult().toJson();
  const auto refusal = [&](const std::string &from, const std::string &to) {
    std::string text = good;
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), from.size(), to);
    return messageOf([&] { vpMbTrackingResult::fromJson(text); });
  };
  CHECK_THAT(refusal("\"score\"", "\"scores\""), ContainsSubstring("'score' is missing"));
  CHECK_THAT(refusal("UNCERTAIN", "FINE"), ContainsSubstring("'state' is not known as \"FINE\""));
  CHECK_THAT(refusal("\"text\":\"\"", "\"text\":3"), ContainsSubstring("'text' is 3"));
  CHECK_THAT(refusal("\"cues\":[]", "\"cues\":[3]"), ContainsSubstring("'type' is missing"));
  CHECK_THAT(refusal("[[1.0", "[[true"), ContainsSubstring("'cMo' has true"));
  CHECK_THAT(refusal("[[1.0,", "[["), ContainsSubstring("'cMo' must be a list of 4 rows of 4 numbers"));
  CHECK_FALSE(refusal("[[1.0", "[[2.0").empty()); // No rotation.
  CHECK_THAT(messageOf([] { vpMbTrackingResult::fromJson("{"); }), ContainsSubstring("no JSON"));
  CHECK_THAT(messageOf([] { vpMbTrackingResult::fromJson(std::string(100000, '[')); }), ContainsSubstring("nested"));
  CHECK_THAT(refusal("\"text\":\"\"", "\"text\":\"\",\"text\":\"\""), ContainsSubstring("'text' is there twice"));
  const Folder folder;
  CHECK_THAT(messageOf([&] { vpMbTrackingResult::readFromJsonFile(folder.path("none.json")); }),
             ContainsSubstring("none.json"));
  CHECK_THAT(messageOf([&] { vpMbTrackingResult::readFromJsonFile(folder.write("bad.json", "{}")); }),
             ContainsSubstring("bad.json") && ContainsSubstring("'cMo' is missing"));
  CHECK_THAT(messageOf([&] { vpMbTrackingResult().saveToFile(folder.path("none/a.json")); }),
             ContainsSubstring("cannot be written"));
}
