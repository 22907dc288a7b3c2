// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "renderedBox.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <type_traits>
#include <utility>

namespace {
using Tracker = vpMbMultiCueTracker;

// Whether a call compiles.
template <typename... Arguments>
using LoadModel = decltype(std::declval<Tracker &>().loadModel(std::declval<Arguments>()...));
template <typename... Arguments>
using LoadConfig = decltype(std::declval<Tracker &>().loadConfigFile(std::declval<Arguments>()...));
template <template <typename...> class Call, typename Enable, typename... Arguments> struct Compiles : std::false_type
{
};
template <template <typename...> class Call, typename... Arguments>
struct Compiles<Call, std::void_t<Call<Arguments...>>, Arguments...> : std::true_type
{
};
template <template <typename...> class Call, typename... Arguments>
constexpr bool compiles = Compiles<Call, void, Arguments...>::value;

static_assert(compiles<LoadModel, const char *, bool>, "");
static_assert(compiles<LoadModel, std::string>, "");
static_assert(!compiles<LoadModel, const char *, const char *>, "two cameras");
static_assert(!compiles<LoadModel, const char (&)[6], const char (&)[6]>, "two cameras");
static_assert(!compiles<LoadModel, const char (&)[6], const char (&)[6], bool>, "two cameras");
static_assert(!compiles<LoadModel, std::string, std::string>, "two cameras");
static_assert(compiles<LoadConfig, const char *, bool>, "");
static_assert(!compiles<LoadConfig, const char (&)[6], const char (&)[6]>, "two cameras");
static_assert(!compiles<LoadConfig, std::string, std::string, bool>, "two cameras");
static_assert(std::is_same<decltype(Tracker::EDGE_TRACKER | Tracker::KLT_TRACKER), Tracker::vpTrackerType>::value, "");
} // namespace

TEST_CASE("Constructors mean what vpMbGenericTracker's do", "[tracker]")
{
  const int all = Tracker::EDGE_TRACKER | Tracker::COLOR_TRACKER;
  CHECK(Tracker(Tracker::COLOR_TRACKER).getTrackerType() == 16);
  CHECK(Tracker(Tracker::EDGE_TRACKER | Tracker::COLOR_TRACKER).getTrackerType() == all);
  CHECK(Tracker(1).getTrackerType() == Tracker().getTrackerType());
  CHECK(Tracker(1, all).getTrackerType() == all);
  CHECK(Tracker(1U, Tracker::EDGE_TRACKER).getTrackerType() == 1);
  CHECK(Tracker(std::vector<int>{all}).getTrackerType() == all);
  const Tracker named({"left"}, {all});
  CHECK(named.getTrackerType() == all);
  CHECK(named.getCameraNames() == std::vector<std::string>{"left"});
  CHECK(named.getCameraTrackerTypes() == std::map<std::string, int>{{"left", all}});
  CHECK_THAT(messageOf([] { Tracker tracker(2); }), ContainsSubstring("2 cameras"));
  CHECK_THAT(messageOf([] { Tracker tracker(2); }), ContainsSubstring("vpMbGenericTracker"));
  CHECK_THROWS_AS(Tracker(0), vpException);
  CHECK_THROWS_AS(Tracker(2U, 1), vpException);
  CHECK_THROWS_AS(Tracker(1, 0), vpException);
  CHECK_THROWS_AS(Tracker(std::vector<int>{1, 1}), vpException);
  CHECK_THROWS_AS(Tracker(std::vector<int>()), vpException);
  CHECK_THROWS_AS(Tracker({"left", "right"}, {1, 1}), vpException);
}

TEST_CASE("Calls with a map of one camera do what those without do", "[tracker]")
{
  renderedBox box;
  const vpHomogeneousMatrix truth = renderedBox::pose();
  const vpImage<unsigned char> I = box.draw(truth);
  const std::map<std::string, const vpImage<unsigned char> *> images = {{"Camera", &I}};
  Tracker tracker(1, Tracker::EDGE_TRACKER);
  CHECK(tracker.getReferenceCameraName() == "Camera");
  tracker.setReferenceCameraName("Camera");
  tracker.setCameraParameters(std::map<std::string, vpCameraParameters>{{"Camera", renderedBox::camera()}});
  tracker.setCameraTransformationMatrix("Camera", vpHomogeneousMatrix());
  tracker.setTrackerType(std::map<std::string, int>{{"Camera", 1}});
  vpMe me = tracker.getMovingEdge();
  me.setRange(12);
  tracker.setMovingEdge(std::map<std::string, vpMe>{{"Camera", me}});
  CHECK(tracker.getMovingEdge().getRange() == 12);
  tracker.setAngleAppear(std::map<std::string, double>{{"Camera", 1.4}});
  CHECK(tracker.getAngleAppear() == exactly(1.4));
  tracker.setKltMaskBorder(std::map<std::string, unsigned int>{{"Camera", 7}});
  CHECK(tracker.getKltMaskBorder() == 7);
  const std::string model = renderedBox::writeCao(meshFiles::temporaryFile("one-camera-box.cao"));
  tracker.loadModel(std::map<std::string, std::string>{{"Camera", model}});
  std::map<std::string, vpHomogeneousMatrix> poses = {{"Camera", truth}};
  tracker.initFromPose(images, poses);
  tracker.track(images);
  poses.clear();
  tracker.getPose(poses);
  REQUIRE(poses.size() == 1);
  CHECK((poses["Camera"].inverse() * truth).getTranslationVector().frobeniusNorm() < 0.001);
  CHECK(&tracker.getFaces("Camera") == &tracker.getFaces());
  CHECK(tracker.getFaces("Camera").getNbVisiblePolygon() == 3);
  std::map<std::string, unsigned int> points;
  tracker.getNbPoints(points);
  CHECK(points["Camera"] == tracker.getNbPoints());
  std::map<std::string, vpCameraParameters> cameras;
  tracker.getCameraParameters(cameras);
  CHECK(cameras["Camera"].get_px() == exactly(600.));
  std::map<std::string, std::vector<vpPolygon>> polygons;
  std::map<std::string, std::vector<std::vector<vpPoint>>> corners;
  tracker.getPolygonFaces(polygons, corners);
  CHECK(polygons["Camera"].size() == 3);

  tracker.setPose(images, {{"Camera", truth}});
  tracker.track(images);
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
  tracker.reInitModel(images, {{"Camera", model}}, {{"Camera", truth}});
  CHECK(tracker.getModelReport().edges == 12);
}

TEST_CASE("Other cameras are refused by name, and nothing changes", "[tracker]")
{
  renderedBox box;
  const vpImage<unsigned char> I = box.draw(renderedBox::pose());
  Tracker tracker(1, Tracker::EDGE_TRACKER);
  tracker.setCameraParameters(renderedBox::camera());
  tracker.loadModel(renderedBox::writeCao(meshFiles::temporaryFile("one-camera-box.cao")));
  tracker.initFromPose(I, renderedBox::pose());
  using Images = std::map<std::string, const vpImage<unsigned char> *>;
  const std::string message = messageOf([&] { tracker.track(Images{{"Camera1", &I}, {"Camera2", &I}}); });
  CHECK_THAT(message, ContainsSubstring("'Camera1', 'Camera2'"));
  CHECK_THAT(message, ContainsSubstring("vpMbGenericTracker"));
  CHECK_THAT(messageOf([&] { tracker.track(Images{{"left", &I}}); }), ContainsSubstring("'left'"));
  CHECK_THAT(messageOf([&] { tracker.track(Images()); }), ContainsSubstring("none"));
  CHECK_THAT(messageOf([&] { tracker.track(Images{{"Camera", nullptr}}); }), ContainsSubstring("null"));
  CHECK_THAT(messageOf([&] { tracker.setReferenceCameraName("left"); }), ContainsSubstring("'left'"));
  CHECK_THROWS_AS(tracker.setCameraTransformationMatrix("Camera", vpHomogeneousMatrix(0.1, 0., 0., 0., 0., 0.)),
                  vpException);
  CHECK(tracker.getScales() == std::vector<bool>{true});
  tracker.setScales({true, false});
  CHECK_THAT(messageOf([&] { tracker.setScales({true, true}); }), ContainsSubstring("range"));
  CHECK_THROWS_AS(tracker.setScales({}), vpException);
  tracker.track(Images{{"Camera", &I}});
  CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
}
