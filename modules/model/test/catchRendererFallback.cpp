// SPDX-License-Identifier: GPL-2.0-or-later
#include "../src/render/vpFallbackRenderer.cpp" // The library keeps it to itself.

#include "renderModels.h"

#include <catchMain.h>

#include <functional>
#include <iostream>

#ifdef MODEL_TESTS_HAVE_EGL
#include <EGL/egl.h>
#include <dlfcn.h>

namespace {
bool losesContext = false;
}

// In the place of EGL's, also for the library: as it is where the graphics card was taken away.
extern "C" __attribute__((visibility("default"))) EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw,
                                                                            EGLSurface read, EGLContext context)
{
  using MakeCurrent = EGLBoolean (*)(EGLDisplay, EGLSurface, EGLSurface, EGLContext);
  static const auto makeCurrent = reinterpret_cast<MakeCurrent>(dlsym(RTLD_NEXT, "eglMakeCurrent"));
  return losesContext ? EGL_FALSE : makeCurrent(display, draw, read, context);
}
#endif

namespace {
const vpHomogeneousMatrix inSight(0., 0., 0.5, 0.1, 0.2, 0.3);

vpRenderedView draw(vpModelRenderer &renderer, const vpHomogeneousMatrix &cMo)
{
  vpRenderedView view;
  renderer.render(cMo, makeCamera(), imageWidth, imageHeight, allChannels(1.), view);
  return view;
}

vpRenderedView drawOnCpu(const ModelPointer &model, const vpHomogeneousMatrix &cMo)
{
  vpCpuRenderer cpu(model);
  return draw(cpu, cMo);
}

bool isSame(const vpRenderedView &a, const vpRenderedView &b)
{
  const auto isSameColor = [](const vpRGBa &x, const vpRGBa &y) { return x.R == y.R && x.G == y.G && x.B == y.B; };
  return a.left == b.left && a.top == b.top && a.width == b.width && a.height == b.height && a.depth == b.depth &&
         a.normal == b.normal && a.face == b.face &&
         std::equal(a.color.begin(), a.color.end(), b.color.begin(), b.color.end(), isSameColor);
}

using Fault = std::function<void(vpRenderedView &)>;

//! What the CPU draws, spoilt.
class SpoiltRenderer : public vpModelRenderer
{
public:
  SpoiltRenderer(const ModelPointer &model, Fault fault) : m_cpu(model), m_fault(std::move(fault)) {}

  void render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int width, unsigned int height,
              const vpRenderOptions &options, vpRenderedView &view) override
  {
    m_cpu.render(cMo, cam, width, height, options, view);
    m_fault(view);
  }
  std::string name() const override { return "spoilt"; }

private:
  vpCpuRenderer m_cpu;
  Fault m_fault;
};

vpFallbackRenderer makeFallback(const ModelPointer &model, const Fault &fault)
{
  return vpFallbackRenderer(std::make_unique<SpoiltRenderer>(model, fault), model);
}

Fault everywhere(float depth)
{
  return [depth](vpRenderedView &view) { std::fill(view.depth.begin(), view.depth.end(), depth); };
}
} // namespace

TEST_CASE("The CPU draws the view that a renderer fails at, and those after it", "[renderer]")
{
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Fault one = [](vpRenderedView &view) { view.depth[view.depth.size() / 2] = 0.9F; };
  const Fault refusal = [](vpRenderedView &) { throw vpException(vpException::fatalError, "the context is lost"); };
  for (const Fault &fault : {everywhere(0.F), everywhere(-1.F), everywhere(nan), everywhere(1e30F), one, refusal}) {
    int times = 0;
    vpFallbackRenderer renderer = makeFallback(box, [&](vpRenderedView &view) {
      if (++times == 2) {
        fault(view);
      }
    });
    CHECK(isSame(draw(renderer, inSight), drawOnCpu(box, inSight)));
    CHECK(renderer.failure().empty());
    CHECK(renderer.name() == "spoilt");
    for (int i = 0; i < 3; ++i) {
      CHECK(isSame(draw(renderer, inSight), drawOnCpu(box, inSight)));
      CHECK_THAT(renderer.failure(), ContainsSubstring("spoilt failed"));
      CHECK(renderer.name() == "CPU");
    }
    CHECK(times == 2);
  }
}

TEST_CASE("A renderer that does as it should is kept, wherever the object is", "[renderer]")
{
  for (const ModelPointer &model : {makeBox(0.1, 0.08, 0.06), makeSquare(0.2)}) {
    vpFallbackRenderer renderer = makeFallback(model, [](vpRenderedView &) {});
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
      draw(renderer, randomPose(random, 5. * model->diameter()));
    }
    for (const double depth : {-0.5, -0.04, 0., 0.001, 0.03, 0.1, 50., 1e6}) {
      CAPTURE(depth);
      draw(renderer, vpHomogeneousMatrix(0., 0., depth, 0.1, 0.2, 0.3));
      draw(renderer, vpHomogeneousMatrix(0., 0., depth, 0., 0., 0.));
      draw(renderer, vpHomogeneousMatrix(0.6 * depth, 0., depth, M_PI / 2., 0., 0.)); // The square: edge-on.
    }
    CHECK(renderer.failure().empty());
  }
}

TEST_CASE("What no renderer can draw is refused, and the next view is drawn", "[renderer]")
{
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  vpFallbackRenderer renderer = makeFallback(box, [](vpRenderedView &) {});
  vpRenderedView view;
  CHECK_THROWS_AS(
      renderer.render(inSight, vpCameraParameters(-1., 1., 0., 0.), imageWidth, imageHeight, vpRenderOptions(), view),
      vpException);
  CHECK(renderer.failure().empty());
  CHECK(isSame(draw(renderer, inSight), drawOnCpu(box, inSight)));
}

#ifdef MODEL_TESTS_HAVE_EGL
TEST_CASE("Where the context of EGL is lost the CPU draws", "[renderer][egl]")
{
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  {
    const std::unique_ptr<vpModelRenderer> renderer = vpModelRenderer::create(box, vpModelRenderer::EGL);
    if (renderer->name() == "CPU") {
      std::cout << "Left out: there is no EGL" << std::endl;
      return;
    }
    draw(*renderer, inSight);
    CHECK(renderer->failure().empty());
    losesContext = true;
    CHECK(isSame(draw(*renderer, inSight), drawOnCpu(box, inSight)));
    CHECK_THAT(renderer->failure(), ContainsSubstring("EGL") && ContainsSubstring("eglMakeCurrent"));
    losesContext = false;
    CHECK(isSame(draw(*renderer, inSight), drawOnCpu(box, inSight)));
  }
  losesContext = true; // The next one is refused its context from the start.
  CHECK(vpModelRenderer::create(box, vpModelRenderer::EGL)->name() == "CPU");
  losesContext = false;
}
#endif
