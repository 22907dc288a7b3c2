// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "boxEdges.h"
#include "renderedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpImageTools.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>

namespace {
double translationError(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm();
}

double rotationError(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  return vpMath::deg((truth.inverse() * cMo).getThetaUVector().getTheta());
}

// A smooth motion of a few pixels from frame to frame.
vpHomogeneousMatrix poseAt(int frame)
{
  const double t = 0.15 * frame;
  vpColVector motion(6);
  motion[0] = 0.03 * std::sin(t);
  motion[1] = 0.02 * std::sin(1.3 * t);
  motion[2] = 0.05 * std::sin(0.7 * t);
  motion[3] = 0.25 * std::sin(0.9 * t);
  motion[4] = 0.25 * std::sin(1.1 * t);
  motion[5] = 0.25 * std::sin(0.8 * t);
  vpHomogeneousMatrix cMo = renderedBox::pose();
  return vpHomogeneousMatrix(cMo.getTranslationVector(), cMo.getRotationMatrix()) * vpExponentialMap::direct(motion);
}

void prepare(vpMbMultiCueTracker &tracker, const std::string &model)
{
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(model);
}

// Tracks 30 frames and returns the largest errors.
std::pair<double, double> follow(vpMbMultiCueTracker &tracker, renderedBox &box, int frames = 30)
{
  std::pair<double, double> worst(0., 0.);
  for (int i = 0; i < frames; ++i) {
    const vpImage<unsigned char> I = box.draw(poseAt(i));
    if (i == 0) {
      tracker.initFromPose(I, poseAt(0));
    }
    tracker.track(I);
    worst.first = std::max(worst.first, translationError(tracker.getPose(), poseAt(i)));
    worst.second = std::max(worst.second, rotationError(tracker.getPose(), poseAt(i)));
    REQUIRE(tracker.getTrackingState() == vpTrackingState::TRACKING);
  }
  return worst;
}
} // namespace

TEST_CASE("A box is followed, with one candidate and with several, from .cao and .obj, by both minimisations",
          "[tracker]")
{
  renderedBox box;
  const std::string cao = renderedBox::writeCao(meshFiles::temporaryFile("followed-box.cao"));
  const std::string obj = renderedBox::writeObj(meshFiles::temporaryFile("followed-box.obj"), 1000.);
  for (const std::string &model : {cao, obj}) {
    for (const unsigned int candidates : {1U, 3U}) {
      for (const vpMbTracker::vpMbtOptimizationMethod method :
           {vpMbTracker::GAUSS_NEWTON_OPT, vpMbTracker::LEVENBERG_MARQUARDT_OPT}) {
        CAPTURE(model, candidates, method);
        vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
        tracker.setModelUnit(0.001); // Of meshes: a .cao is in metres.
        prepare(tracker, model);
        vpEdgeCueSettings settings = tracker.getEdgeSettings();
        settings.candidates = candidates;
        tracker.setEdgeSettings(settings);
        tracker.setOptimizationMethod(method);
        const std::pair<double, double> worst = follow(tracker, box);
        CHECK(worst.first < 0.0005);
        CHECK(worst.second < 0.15);
      }
    }
  }
}

TEST_CASE("Colour images give the poses of gray ones, and the same images the same poses to the last bit", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker gray(vpMbMultiCueTracker::EDGE_TRACKER), color(vpMbMultiCueTracker::EDGE_TRACKER),
      again(vpMbMultiCueTracker::EDGE_TRACKER);
  for (vpMbMultiCueTracker *tracker : {&gray, &color, &again}) {
    prepare(*tracker, renderedBox::writeCao(meshFiles::temporaryFile("colour-box.cao")));
  }
  for (int i = 0; i < 5; ++i) {
    const vpImage<unsigned char> I = box.draw(poseAt(i));
    vpImage<vpRGBa> Ic;
    vpImageConvert::convert(I, Ic);
    if (i == 0) {
      gray.initFromPose(I, poseAt(0));
      again.initFromPose(I, poseAt(0));
      color.initFromPose(Ic, poseAt(0));
    }
    gray.track(I);
    again.track(I);
    color.track(Ic);
    CHECK(translationError(color.getPose(), gray.getPose()) < 1e-4);
    for (unsigned int k = 0; k < 16; ++k) {
      CHECK(again.getPose().data[k] == exactly(gray.getPose().data[k]));
    }
  }
}

TEST_CASE("Degrees of freedom that are not estimated stay, in the object's frame", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker, renderedBox::writeCao(meshFiles::temporaryFile("dof-box.cao")));
  vpColVector free(6, 1.);
  free[2] = 0.;
  free[4] = 0.;
  tracker.setEstimatedDoF(free);
  const vpHomogeneousMatrix start = renderedBox::pose();
  tracker.initFromPose(box.draw(start), start);
  vpColVector motion(6, 0.);
  motion[0] = 0.002;
  motion[3] = 0.01;
  const vpHomogeneousMatrix truth = start * vpExponentialMap::direct(motion);
  for (int i = 0; i < 3; ++i) {
    tracker.track(box.draw(truth));
  }
  CHECK(translationError(tracker.getPose(), truth) < 0.0005);
  motion = 0.;
  motion[2] = 0.003; // Along the object's z, which is held.
  tracker.track(box.draw(truth * vpExponentialMap::direct(motion)));
  const vpColVector moved = vpExponentialMap::inverse(truth.inverse() * tracker.getPose());
  CHECK(std::fabs(moved[2]) < 1e-4);
  CHECK(std::fabs(moved[4]) < 1e-3);
  CHECK(tracker.getEstimatedDoF()[2] == exactly(0.));
  CHECK(tracker.getEstimatedDoF()[0] == exactly(1.));
}

TEST_CASE("The covariance is that of the pose, and nothing is left of a mask", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker, renderedBox::writeCao(meshFiles::temporaryFile("covariance-box.cao")));
  tracker.setCovarianceComputation(true);
  tracker.setProjectionErrorComputation(true);
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  tracker.initFromPose(I, renderedBox::pose());
  tracker.track(I);
  const vpMatrix covariance = tracker.getCovarianceMatrix();
  REQUIRE(covariance.getRows() == 6);
  for (unsigned int i = 0; i < 6; ++i) {
    CHECK(covariance[i][i] > 0.);
    CHECK(covariance[i][i] < 1e-4);
  }
  CHECK(tracker.getProjectionError() < 5.);
  CHECK(tracker.getError().getRows() == tracker.getRobustWeights().getRows());
  CHECK(tracker.getNbFeaturesEdge() == tracker.getError().getRows());
  CHECK(tracker.getNbPoints() > 100);

  const auto isInLeftHalf = [](const std::vector<double> &feature) { return feature[2] < 319.; };
  const std::vector<std::vector<double>> unmasked = tracker.getFeaturesForDisplay();
  CHECK(std::any_of(unmasked.begin(), unmasked.end(), isInLeftHalf));
  vpImage<bool> mask(480, 640, true);
  for (unsigned int i = 0; i < 480; ++i) {
    for (unsigned int j = 0; j < 320; ++j) {
      mask[i][j] = false;
    }
  }
  tracker.setMask(mask);
  tracker.track(I);
  const std::vector<std::vector<double>> features = tracker.getFeaturesForDisplay();
  CHECK(features.size() > 20);
  CHECK(std::none_of(features.begin(), features.end(), isInLeftHalf));
  CHECK(tracker.getNbFeaturesEdge() > 20);
}

TEST_CASE("What is displayed are the visible edges", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker, renderedBox::writeCao(meshFiles::temporaryFile("display-box.cao")));
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  tracker.initFromPose(I, renderedBox::pose());
  tracker.track(I);
  const std::vector<BoxEdge> edges = boxEdges(renderedBox::pose());
  for (const bool full : {false, true}) {
    std::vector<double> shown(edges.size(), 0.); // Of each edge, pixels.
    for (const std::vector<double> &line :
         tracker.getModelForDisplay(640, 480, renderedBox::pose(), renderedBox::camera(), full)) {
      REQUIRE(line.size() == 5);
      CHECK(line[0] == exactly(0.));
      const vpImagePoint from(line[1], line[2]);
      const vpImagePoint to(line[3], line[4]);
      const auto edge = std::find_if(edges.begin(), edges.end(), [&](const BoxEdge &e) {
        return e.distance(from) < 0.01 && e.distance(to) < 0.01;
      });
      REQUIRE(edge != edges.end());
      shown[static_cast<std::size_t>(edge - edges.begin())] += vpImagePoint::distance(from, to);
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      CAPTURE(full, i);
      const double expected = full || edges[i].isVisible ? vpImagePoint::distance(edges[i].from, edges[i].to) : 0.;
      CHECK(std::fabs(shown[i] - expected) < 1.);
    }
  }
  CHECK(std::count_if(edges.begin(), edges.end(), [](const BoxEdge &e) { return e.isVisible; }) == 9);
  const std::vector<std::vector<double>> features = tracker.getFeaturesForDisplay();
  CHECK(features.size() > 100);
  for (const std::vector<double> &feature : features) {
    REQUIRE(feature.size() == 4);
    CHECK(feature[0] == exactly(0.));
    CHECK(feature[3] == exactly(0.)); // vpMeSite::NO_SUPPRESSION: all of them are found here.
    CHECK(std::any_of(edges.begin(), edges.end(), [&](const BoxEdge &e) {
      return e.isVisible && e.distance(vpImagePoint(feature[1], feature[2])) < 2.;
    }));
  }
  CHECK(tracker.computeCurrentProjectionError(I, renderedBox::pose(), renderedBox::camera()) < 5.);
  vpHomogeneousMatrix wrong = renderedBox::pose() * vpHomogeneousMatrix(0.02, 0.02, 0., 0., 0., 0.3);
  CHECK(tracker.computeCurrentProjectionError(I, wrong, renderedBox::camera()) > 15.);
}

TEST_CASE("A camera with lens distortion is tracked with and displayed in its own image", "[tracker]")
{
  renderedBox box;
  const vpCameraParameters plain = renderedBox::camera();
  const vpCameraParameters distorted(plain.get_px(), plain.get_py(), plain.get_u0(), plain.get_v0(), -0.15, 0.16);
  const vpHomogeneousMatrix truth = renderedBox::pose();
  const vpImage<unsigned char> undistorted = box.draw(truth);
  vpImage<unsigned char> I(480, 640);
  for (unsigned int i = 0; i < 480; ++i) {
    for (unsigned int j = 0; j < 640; ++j) {
      double x = 0., y = 0.;
      vpPixelMeterConversion::convertPoint(distorted, j, i, x, y);
      const vpImagePoint from(y * plain.get_py() + plain.get_v0(), x * plain.get_px() + plain.get_u0());
      const bool inside = from.get_i() >= 0. && from.get_j() >= 0. && from.get_i() < 479. && from.get_j() < 639.;
      I[i][j] = inside ? undistorted.getValue(from) : renderedBox::background;
    }
  }
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.setCameraParameters(distorted);
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("distorted-box.cao")));
  tracker.initFromPose(I, truth * vpHomogeneousMatrix(0.002, -0.001, 0.001, 0., 0.01, 0.));
  for (int i = 0; i < 2; ++i) {
    tracker.track(I);
  }
  CHECK(translationError(tracker.getPose(), truth) < 0.001);
  CHECK(rotationError(tracker.getPose(), truth) < 0.2);
}

TEST_CASE("Moving-edge parameters are honoured and told in both scales", "[tracker]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  CHECK(tracker.getMovingEdge().getThreshold() == Approx(10000.)); // 5 gray levels for a mask of 5 x 5.
  vpMe me;
  me.setMaskSize(7);
  me.setRange(12);
  me.setMu1(0.4);
  me.setMu2(0.6);
  me.setSampleStep(6.);
  me.setThreshold(42000.);
  tracker.setMovingEdge(me, vpEdgeCueSettings::LIKELIHOOD);
  CHECK(tracker.getEdgeSettings().contrast == Approx(10.)); // 42000 / (2 * 100 * 7 * 3)
  CHECK(tracker.getEdgeSettings().range == exactly(12.));
  CHECK(tracker.getMovingEdge().getThreshold() == exactly(42000.));
  CHECK(tracker.getMovingEdge().getSampleStep() == exactly(6.));
  me.setThreshold(20.);
  tracker.setMovingEdge(me, vpEdgeCueSettings::CONTRAST);
  CHECK(tracker.getEdgeSettings().contrast == exactly(20.));
  tracker.resetTracker(); // Keeps them, as ViSP's trackers do.
  CHECK(tracker.getMovingEdge().getRange() == 12);
}

TEST_CASE("A jump of the light does not lose the object", "[tracker]")
{
  renderedBox box;
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  prepare(tracker, renderedBox::writeCao(meshFiles::temporaryFile("light-box.cao")));
  vpImage<unsigned char> I = box.draw(renderedBox::pose());
  tracker.initFromPose(I, renderedBox::pose());
  tracker.track(I);
  for (const double gain : {0.4, 1., 0.3}) {
    vpImage<unsigned char> lit(I.getHeight(), I.getWidth());
    std::transform(I.bitmap, I.bitmap + I.getSize(), lit.bitmap,
                   [gain](unsigned char level) { return static_cast<unsigned char>(gain * level); });
    tracker.track(lit);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    CHECK(translationError(tracker.getPose(), renderedBox::pose()) < 0.0005);
  }
}

TEST_CASE("Several files make one model, and resetTracker forgets them", "[tracker]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  const std::string box = renderedBox::writeCao(meshFiles::temporaryFile("part-box.cao"));
  tracker.loadModel(box);
  CHECK(tracker.getModelReport().edges == 12);
  tracker.loadModel(box, false, vpHomogeneousMatrix(0.5, 0., 0., 0., 0., 0.));
  CHECK(tracker.getModelReport().edges == 24);
  CHECK(tracker.getNbPolygon() == 12);
  CHECK(tracker.getModelReport().size.x() == Approx(0.7));

  std::ofstream parent(meshFiles::temporaryFile("parent.cao"));
  parent << "V1\nload(\"part-box.cao\") # one\nload(\"part-box.cao\", t=[0.5; 0; 0])\n";
  parent.close();
  tracker.setCameraParameters(renderedBox::camera());
  const vpImage<unsigned char> I(480, 640, 0);
  tracker.reInitModel(I, meshFiles::temporaryFile("parent.cao"), renderedBox::pose());
  CHECK(tracker.getModelReport().edges == 24);
  CHECK(tracker.getNbPolygon() == 12);

  tracker.resetTracker();
  CHECK_THROWS_AS(tracker.getModelReport(), vpException);
  CHECK(tracker.getNbPolygon() == 0);
}
