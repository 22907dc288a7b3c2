// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/vpFallbackRenderer.cpp" // The library keeps it to itself.

#include <catchMain.h>
#include <exceptionMessage.h>

#include "plainScene.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelRenderer.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

namespace {
//! What becomes of a depth buffer.
enum class Fault
{
  NONE,
  REFUSED,
  EMPTY,
  NOT_A_NUMBER,
  INFINITE,
  NEGATIVE,
  NEAR
};

Fault fault = Fault::NONE;
long drawn = 0;
bool fallsBack = false; // As the library's renderers do.

float spoilt(float depth)
{
  switch (fault) {
  case Fault::EMPTY:
    return 0.F;
  case Fault::NOT_A_NUMBER:
    return std::numeric_limits<float>::quiet_NaN();
  case Fault::INFINITE:
    return std::numeric_limits<float>::infinity();
  case Fault::NEGATIVE:
    return -depth;
  case Fault::NEAR:
    return std::numeric_limits<float>::min();
  default:
    return depth;
  }
}

//! Draws as it should until it is told not to.
class FaultyRenderer : public vpModelRenderer
{
public:
  explicit FaultyRenderer(const std::shared_ptr<const vpTrackedModel> &model) : m_cpu(model) {}

  void render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
              unsigned int imageHeight, const vpRenderOptions &options, vpRenderedView &view) override
  {
    ++drawn;
    if (fault == Fault::REFUSED) {
      throw vpException(vpException::fatalError, "the context is lost");
    }
    m_cpu.render(cMo, cam, imageWidth, imageHeight, options, view);
    std::transform(view.depth.begin(), view.depth.end(), view.depth.begin(), spoilt);
  }
  std::string name() const override { return "faulty"; }

private:
  vpCpuRenderer m_cpu;
};
} // namespace

// In the library's place: the program's own functions are found before those of shared libraries. It is weak, as static
// libraries have another one, and the tests are left out there.
BEGIN_VISP_NAMESPACE
__attribute__((weak)) std::unique_ptr<vpModelRenderer>
vpModelRenderer::create(const std::shared_ptr<const vpTrackedModel> &model, Preference)
{
  auto renderer = std::make_unique<FaultyRenderer>(model);
  return fallsBack ? std::unique_ptr<vpModelRenderer>(std::make_unique<vpFallbackRenderer>(std::move(renderer), model))
                   : std::move(renderer);
}
END_VISP_NAMESPACE

namespace {
struct Followed
{
  explicit Followed(bool hasAllCues, bool withFallback = false)
  {
    fault = Fault::NONE;
    fallsBack = withFallback;
    const std::string file = meshFiles::temporaryFile("step.stl");
    std::ofstream(file) << meshFiles::asciiStl(stepTriangles());
    tracker.setFrameDeadline(0.);
    if (!hasAllCues) {
      tracker.setPreset(vpMultiCuePreset::FAST);
    }
    tracker.setCameraParameters(plainScene::camera());
    tracker.loadModel(file);
    drawn = 0;
    tracker.initFromPose(scene.draw(plainScene::poseAt(0)), plainScene::poseAt(0));
    for (int i = 1; i <= 4; ++i) {
      show(i);
      REQUIRE(isTracking());
      REQUIRE(isRight(i));
    }
  }

  void show(int i) { tracker.track(scene.draw(plainScene::poseAt(i))); }
  bool isTracking() const { return tracker.getTrackingState() == vpTrackingState::TRACKING; }
  bool isRight(int i) const
  {
    const vpHomogeneousMatrix cMo = tracker.getPose();
    const double shift = (cMo.getTranslationVector() - plainScene::poseAt(i).getTranslationVector()).frobeniusNorm();
    return shift < 0.01 && plainScene::tilt(cMo, plainScene::poseAt(i)) < 4.;
  }

  plainScene scene{stepTriangles()};
  vpMbMultiCueTracker tracker;
};

bool isFinite(const vpHomogeneousMatrix &cMo)
{
  return std::all_of(cMo.data, cMo.data + 16, [](double x) { return std::isfinite(x); });
}

//! \return True where the library takes this program's renderer.
bool takesFaultyRenderer(const Followed &followed)
{
  static_cast<void>(followed);
  if (drawn == 0) {
    WARN("Left out: the libraries are static, and have a renderer of their own");
  }
  return drawn > 0;
}
} // namespace

TEST_CASE("A renderer that refuses a frame is told, the last pose stays, and the tracker goes on", "[tracker]")
{
  const bool hasAllCues = GENERATE(false, true);
  CAPTURE(hasAllCues);
  Followed followed(hasAllCues);
  if (!takesFaultyRenderer(followed)) {
    return;
  }
  const vpHomogeneousMatrix before = followed.tracker.getPose();
  const vpImage<vpRGBa> I = followed.scene.draw(plainScene::poseAt(5));
  fault = Fault::REFUSED;
  for (int times = 0; times < 3; ++times) {
    CHECK_THAT(messageOf([&] { followed.tracker.track(I); }), ContainsSubstring("the context is lost"));
    const vpHomogeneousMatrix after = followed.tracker.getPose();
    CHECK(std::equal(before.data, before.data + 16, after.data));
  }
  fault = Fault::NONE;
  for (int i = 5; i < 8; ++i) {
    followed.show(i);
    CHECK(followed.isTracking());
    CHECK(followed.isRight(i));
  }
}

TEST_CASE("Depth buffers full of garbage leave a pose that can be, a reason, and a tracker that goes on", "[tracker]")
{
  const bool hasAllCues = GENERATE(false, true);
  for (const Fault kind : {Fault::EMPTY, Fault::NOT_A_NUMBER, Fault::INFINITE, Fault::NEGATIVE, Fault::NEAR}) {
    CAPTURE(hasAllCues, static_cast<int>(kind));
    Followed followed(hasAllCues);
    if (!takesFaultyRenderer(followed)) {
      return;
    }
    fault = kind;
    for (int i = 5; i < 8; ++i) {
      CHECK_NOTHROW(followed.show(i));
      const vpMbTrackingResult result = followed.tracker.getTrackingResult();
      CHECK(isFinite(result.cMo));
      CHECK(!result.text.empty());
      CHECK((!followed.isTracking() || followed.isRight(i)));
    }
    fault = Fault::NONE;
    for (int i = 8; i < 14; ++i) {
      CHECK_NOTHROW(followed.show(i));
    }
    CHECK(followed.tracker.getTrackingState() != vpTrackingState::LOST); // After a loss it may wait to be sure.
    CHECK(followed.isRight(13));
  }
}

TEST_CASE("Where a renderer fails the CPU draws from then on, which is told once, and tracking goes on", "[tracker]")
{
  const bool hasAllCues = GENERATE(false, true);
  for (const Fault kind :
       {Fault::REFUSED, Fault::EMPTY, Fault::NOT_A_NUMBER, Fault::INFINITE, Fault::NEGATIVE, Fault::NEAR}) {
    CAPTURE(hasAllCues, static_cast<int>(kind));
    Followed followed(hasAllCues, true);
    if (!takesFaultyRenderer(followed)) {
      return;
    }
    fault = kind;
    for (int i = 5; i < 9; ++i) {
      CHECK_NOTHROW(followed.show(i));
      const std::string text = followed.tracker.getTrackingResult().text;
      CHECK((text.find("faulty failed") != std::string::npos) == (i == 5));
      CHECK((kind != Fault::REFUSED || i > 5 || text.find("the context is lost") != std::string::npos));
      CHECK(followed.isTracking());
      CHECK(followed.isRight(i));
    }
  }
}
