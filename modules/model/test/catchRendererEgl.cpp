// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpEglRenderer.h>

#include "renderModels.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpCpuRenderer.h>

#include <catchMain.h>

#ifdef MODEL_TESTS_HAVE_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#endif

#include <cstdlib>
#include <iostream>

namespace {
constexpr int skipped = 77; //!< What ctest is told to take for "skipped".

//! Ends the test as skipped where there is no EGL.
std::unique_ptr<vpEglRenderer> makeEgl(const ModelPointer &model)
{
  try {
    return std::make_unique<vpEglRenderer>(model);
  } catch (const vpException &e) {
    std::cout << "Skipped: " << e.getStringMessage() << std::endl;
    std::exit(skipped);
  }
}

//! What differs between two views of the same crop.
struct Difference
{
  long object = 0;     //!< Pixels that either view has on the object.
  long silhouette = 0; //!< Pixels that one view alone has on the object.
  long surface = 0;    //!< Pixels away from depth edges that both have on the object.
  double depth = 0.;   //!< Largest relative difference there.
  long face = 0;       //!< Pixels there with different faces.
};

//! True where the pixel and its neighbours are on one smooth piece of the object.
bool awayFromEdges(const vpRenderedView &view, int row, int column)
{
  if (row == 0 || column == 0 || row + 1 == view.height || column + 1 == view.width) {
    return false;
  }
  const std::size_t centre = static_cast<std::size_t>(row * view.width + column);
  for (int i = row - 1; i <= row + 1; ++i) {
    for (int j = column - 1; j <= column + 1; ++j) {
      const std::size_t neighbour = static_cast<std::size_t>(i * view.width + j);
      if (view.face[neighbour] != view.face[centre] ||
          std::abs(view.depth[neighbour] - view.depth[centre]) > 0.02F * view.depth[centre]) {
        return false;
      }
    }
  }
  return true;
}

Difference compare(const vpRenderedView &cpu, const vpRenderedView &egl)
{
  Difference difference;
  for (int row = 0; row < cpu.height; ++row) {
    for (int column = 0; column < cpu.width; ++column) {
      const std::size_t i = static_cast<std::size_t>(row * cpu.width + column);
      const bool onCpu = cpu.depth[i] > 0.F;
      const bool onEgl = egl.depth[i] > 0.F;
      difference.object += onCpu || onEgl ? 1 : 0;
      difference.silhouette += onCpu != onEgl ? 1 : 0;
      if (onCpu && onEgl && awayFromEdges(cpu, row, column)) {
        ++difference.surface;
        difference.depth = std::max(
            difference.depth, std::abs(static_cast<double>(egl.depth[i]) / static_cast<double>(cpu.depth[i]) - 1.));
        difference.face += cpu.face[i] != egl.face[i] ? 1 : 0;
      }
    }
  }
  return difference;
}

void compareRenderers(const ModelPointer &model, double scale)
{
  const std::unique_ptr<vpEglRenderer> egl = makeEgl(model);
  vpCpuRenderer cpu(model);
  const vpCameraParameters cam = makeCamera();
  std::mt19937 random(7);
  vpRenderedView onCpu;
  vpRenderedView onEgl;
  long surface = 0;
  long object = 0;
  long silhouette = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const vpHomogeneousMatrix cMo = randomPose(random, 5. * model->diameter());
    cpu.render(cMo, cam, imageWidth, imageHeight, allChannels(scale), onCpu);
    egl->render(cMo, cam, imageWidth, imageHeight, allChannels(scale), onEgl);
    REQUIRE(onEgl.left == onCpu.left);
    REQUIRE(onEgl.top == onCpu.top);
    REQUIRE(onEgl.width == onCpu.width);
    REQUIRE(onEgl.height == onCpu.height);
    REQUIRE(onEgl.normal.size() == onCpu.normal.size());
    REQUIRE(onEgl.color.size() == onCpu.color.size());
    const Difference difference = compare(onCpu, onEgl);
    CAPTURE(trial, difference.object, difference.silhouette);
    CHECK(difference.depth < 0.001);
    CHECK(difference.face == 0);
    surface += difference.surface;
    object += difference.object;
    silhouette += difference.silhouette;
  }
  CHECK(static_cast<double>(object) > 24000. * scale * scale);
  CHECK(surface > object / 3);
  CHECK(static_cast<double>(silhouette) < 0.005 * static_cast<double>(object));
}
} // namespace

TEST_CASE("EGL sees what the CPU renderer sees", "[renderer][egl]")
{
  const double scale = GENERATE(1., 0.5);
  CAPTURE(scale);
  SECTION("box")
  {
    compareRenderers(makeBox(0.1, 0.08, 0.06), scale);
  }
  SECTION("L-shape")
  {
    compareRenderers(makeLShape(0.12, 0.03), scale);
  }
  SECTION("cylinder")
  {
    compareRenderers(makeCylinder(0.04, 0.15), scale);
  }
  SECTION("sphere")
  {
    compareRenderers(makeSphere(0.1, 36), scale);
  }
}

TEST_CASE("EGL gives a tilted plane its depth, normal and colour", "[renderer][egl]")
{
  const ModelPointer square = makeSquare(0.2);
  const std::unique_ptr<vpEglRenderer> egl = makeEgl(square);
  const vpCameraParameters cam(600., 600., 320., 240.);
  const double tilt = 0.6;
  vpRenderedView view;
  egl->render(vpHomogeneousMatrix(0., 0., 0.5, tilt, 0., 0.), cam, imageWidth, imageHeight, allChannels(), view);
  for (const double v : {180., 240., 290.}) {
    // The plane through (0, 0, 0.5) with normal (0, -sin, cos).
    const double expected = 0.5 * std::cos(tilt) / (std::cos(tilt) - std::sin(tilt) * (v - 240.) / 600.);
    const int index = view.index(320., v);
    REQUIRE(index >= 0);
    const std::size_t i = static_cast<std::size_t>(index);
    CHECK(static_cast<double>(view.depth[i]) == Approx(expected).epsilon(1e-5));
    CHECK(view.normal[i].y() == Approx(std::sin(tilt)).epsilon(1e-5));
    CHECK(view.normal[i].z() == Approx(-std::cos(tilt)).epsilon(1e-5));
    CHECK(view.face[i] == 0);
    CHECK((view.color[i].R == 128 && view.color[i].A == 255));
  }
  CHECK(egl->name().find("EGL (") == 0);
}

TEST_CASE("EGL cuts at the near plane and gives nothing outside the image", "[renderer][egl]")
{
  const ModelPointer floor = makeSquare(4.);
  const std::unique_ptr<vpEglRenderer> egl = makeEgl(floor);
  vpCpuRenderer cpu(floor);
  const vpCameraParameters cam(600., 600., 320., 240.);
  vpRenderOptions options = allChannels();
  options.nearDistance = 0.35;
  vpRenderedView onCpu;
  vpRenderedView onEgl;
  const vpHomogeneousMatrix cMo(0., 0.1, 0.5, pi / 2., 0., 0.);
  cpu.render(cMo, cam, imageWidth, imageHeight, options, onCpu);
  egl->render(cMo, cam, imageWidth, imageHeight, options, onEgl);
  const Difference difference = compare(onCpu, onEgl);
  CHECK(difference.object > 50000);
  CHECK(difference.silhouette < difference.object / 200);
  CHECK(difference.depth < 0.001);

  egl->render(vpHomogeneousMatrix(0., 0., -9., 0., 0., 0.), cam, imageWidth, imageHeight, options, onEgl);
  CHECK(onEgl.width * onEgl.height == 0);
  CHECK(onEgl.depth.empty());
}

TEST_CASE("One EGL renderer draws crops of any size and any channels one after the other", "[renderer][egl]")
{
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  const std::unique_ptr<vpEglRenderer> egl = makeEgl(box);
  vpCpuRenderer cpu(box);
  vpRenderOptions options = allChannels();
  vpRenderedView onCpu;
  vpRenderedView onEgl;
  for (const double distance : {0.8, 0.3, 0.5, 2., 0.25}) {
    const vpHomogeneousMatrix cMo(-0.05, -0.04, distance, 0.5, 0.3, 0.2);
    options.channels = allChannels().channels;
    cpu.render(cMo, makeCamera(), imageWidth, imageHeight, options, onCpu);
    egl->render(cMo, makeCamera(), imageWidth, imageHeight, options, onEgl);
    const Difference difference = compare(onCpu, onEgl);
    CHECK(difference.depth < 0.001);
    CHECK(difference.silhouette <= 4 + difference.object / 200);
    const std::vector<float> depth = onEgl.depth;
    options.channels = vpRenderOptions::DEPTH;
    egl->render(cMo, makeCamera(), imageWidth, imageHeight, options, onEgl);
    CHECK(onEgl.depth == depth);
    CHECK(onEgl.face.empty());
  }
}

TEST_CASE("EGL renderers come and go beside each other", "[renderer][egl]")
{
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  const vpHomogeneousMatrix cMo(-0.05, -0.04, 0.5, 0.5, 0.3, 0.2);
  const std::unique_ptr<vpEglRenderer> lasting = makeEgl(box);
  vpRenderedView expected;
  vpRenderedView view;
  lasting->render(cMo, makeCamera(), imageWidth, imageHeight, allChannels(), expected);
  for (int i = 0; i < 50; ++i) {
    const std::unique_ptr<vpEglRenderer> passing = makeEgl(box);
    passing->render(cMo, makeCamera(), imageWidth, imageHeight, allChannels(), view);
    REQUIRE(view.depth == expected.depth);
    lasting->render(cMo, makeCamera(), imageWidth, imageHeight, allChannels(), view);
    REQUIRE(view.depth == expected.depth);
  }
}

TEST_CASE("create() takes EGL where it is asked for, and a GPU alone by itself", "[renderer][egl]")
{
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  const std::unique_ptr<vpEglRenderer> egl = makeEgl(box);
  CHECK(vpModelRenderer::create(box, vpModelRenderer::EGL)->name() == egl->name());
  CHECK(vpModelRenderer::create(box, vpModelRenderer::AUTOMATIC)->name() == "CPU");
  const ModelPointer large = makeSphere(0.1, 75);
  const std::string expected = egl->isSoftware() ? "CPU" : egl->name();
  CHECK(vpModelRenderer::create(large, vpModelRenderer::AUTOMATIC)->name() == expected);
}

#ifdef MODEL_TESTS_HAVE_EGL
namespace {
EGLDisplay openApplicationDisplay()
{
  EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (!eglInitialize(display, nullptr, nullptr)) {
    display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  }
  return eglInitialize(display, nullptr, nullptr) ? display : EGL_NO_DISPLAY;
}
} // namespace

TEST_CASE("The application's own EGL context stays current", "[renderer][egl]")
{
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  std::unique_ptr<vpEglRenderer> egl = makeEgl(box);
  CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);

  const EGLDisplay display = openApplicationDisplay();
  if (display == EGL_NO_DISPLAY) {
    WARN("There is no display for an application's context here");
    return;
  }
  EGLint count = 0;
  EGLConfig config = nullptr;
  const EGLint configAttributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES2_BIT,
                                     EGL_NONE};
  const EGLint surfaceAttributes[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
  const EGLint contextAttributes[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
  REQUIRE(eglBindAPI(EGL_OPENGL_ES_API));
  REQUIRE(eglChooseConfig(display, configAttributes, &config, 1, &count));
  REQUIRE(count == 1);
  const EGLSurface surface = eglCreatePbufferSurface(display, config, surfaceAttributes);
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, contextAttributes);
  REQUIRE(eglMakeCurrent(display, surface, surface, context));
  const auto unchanged = [&] {
    return eglGetCurrentContext() == context && eglGetCurrentDisplay() == display &&
           eglGetCurrentSurface(EGL_DRAW) == surface && eglGetCurrentSurface(EGL_READ) == surface &&
           eglQueryAPI() == EGL_OPENGL_ES_API;
  };

  vpRenderedView view;
  egl->render(vpHomogeneousMatrix(0., 0., 0.5, 0., 0., 0.), makeCamera(), imageWidth, imageHeight, allChannels(), view);
  CHECK(coveredPixels(view) > 1000);
  CHECK(unchanged());
  std::unique_ptr<vpEglRenderer> second = makeEgl(box);
  CHECK(unchanged());
  egl.reset();
  second.reset();
  CHECK(unchanged());
  vpRenderOptions unusable;
  unusable.scale = 0.;
  egl = makeEgl(box);
  const vpHomogeneousMatrix cMo;
  CHECK_THROWS_AS(egl->render(cMo, makeCamera(), imageWidth, imageHeight, unusable, view), vpException);
  CHECK(unchanged());

  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroySurface(display, surface);
  eglDestroyContext(display, context);
}
#endif
