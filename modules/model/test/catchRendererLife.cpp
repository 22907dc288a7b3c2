// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpCpuRenderer.h>

#include "renderModels.h"

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
//! Called through a pointer, as compilers warn where they see free() on what new gave.
void (*volatile release)(void *) = std::free;
} // namespace

// Every allocation of the process, the library's included, is counted.
void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void *operator new(std::size_t size)
{
  if (void *memory = operator new(size, std::nothrow)) {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void *memory) noexcept
{
  release(memory);
}
void operator delete(void *memory, std::size_t) noexcept
{
  release(memory);
}

TEST_CASE("Memory is used again, and channels that are not asked for are empty", "[renderer]")
{
  const ModelPointer model = makeSphere(0.1, 20);
  vpCpuRenderer renderer(model);
  const vpHomogeneousMatrix cMo(0., 0., 0.6, 0.3, 0.2, 0.1);
  vpRenderedView view;
  renderer.render(cMo, makeCamera(), imageWidth, imageHeight, allChannels(), view);
  const vpRenderedView first = view;
  const vpCameraParameters cam = makeCamera();
  const vpRenderOptions onlyDepth;
  const vpRenderOptions all = allChannels();
  const long before = allocations;
  renderer.render(cMo, cam, imageWidth, imageHeight, onlyDepth, view);
  const long afterDepth = allocations;
  CHECK(afterDepth == before);
  CHECK(view.depth == first.depth);
  CHECK(view.normal.empty());
  CHECK(view.face.empty());
  CHECK(view.color.empty());
  const long beforeAll = allocations;
  renderer.render(cMo, cam, imageWidth, imageHeight, all, view);
  const long afterAll = allocations;
  CHECK(afterAll == beforeAll);
  CHECK(view.depth == first.depth);
  CHECK(view.face == first.face);
}

TEST_CASE("Unusable input is refused by name", "[renderer]")
{
  const ModelPointer model = makeSquare(0.1);
  vpCpuRenderer renderer(model);
  const vpHomogeneousMatrix cMo(0., 0., 0.5, 0., 0., 0.);
  const vpCameraParameters cam = makeCamera();
  vpRenderedView view;
  const auto message = [&](const vpHomogeneousMatrix &pose, const vpCameraParameters &camera, unsigned int width,
                           const vpRenderOptions &options) -> std::string {
    try {
      renderer.render(pose, camera, width, imageHeight, options, view);
    } catch (const vpException &e) {
      return e.getStringMessage();
    }
    return "";
  };
  vpHomogeneousMatrix broken = cMo;
  broken[0][3] = std::nan("");
  vpRenderOptions scale;
  scale.scale = 1.5;
  vpRenderOptions margin;
  margin.margin = -1.;
  vpRenderOptions nearDistance;
  nearDistance.nearDistance = 0.;
  vpRenderOptions channels;
  channels.channels = 64;
  CHECK(message(cMo, cam, imageWidth, vpRenderOptions()).empty());
  CHECK_THAT(message(cMo, cam, 0, vpRenderOptions()), ContainsSubstring("0 x 480"));
  CHECK_THAT(message(broken, cam, imageWidth, vpRenderOptions()), ContainsSubstring("cMo"));
  CHECK_THAT(message(cMo, vpCameraParameters(600., std::nan(""), 320., 240.), imageWidth, vpRenderOptions()),
             ContainsSubstring("py"));
  CHECK_THAT(message(cMo, cam, imageWidth, scale), ContainsSubstring("scale is 1.5"));
  CHECK_THAT(message(cMo, cam, imageWidth, margin), ContainsSubstring("margin"));
  CHECK_THAT(message(cMo, cam, imageWidth, nearDistance), ContainsSubstring("nearDistance"));
  CHECK_THAT(message(cMo, cam, imageWidth, channels), ContainsSubstring("channels is 64"));
  CHECK_THROWS_AS(vpCpuRenderer(nullptr), vpException);
  CHECK_THROWS_AS(vpModelRenderer::create(nullptr), vpException);
  CHECK(vpModelRenderer::create(model, vpModelRenderer::CPU)->name() == "CPU");
  CHECK(vpModelRenderer::create(model)->name() == "CPU");
}
