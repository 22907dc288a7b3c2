// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpEglRenderer.h>

#include "renderModels.h"

#include <visp3/core/vpException.h>

#include <catchMain.h>

#include <cstdlib>
#include <iostream>
#include <sstream>

namespace {
//! EGL's loader reads this at its first use: no driver is found from then on. A process of its own, hence this file.
void hideEgl()
{
#ifndef _WIN32
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
#endif
}
} // namespace

TEST_CASE("Without EGL there is a CPU renderer, and the reason is told once", "[renderer]")
{
  hideEgl();
  const ModelPointer box = makeBox(0.1, 0.08, 0.06);
  std::ostringstream told;
  std::streambuf *before = std::cerr.rdbuf(told.rdbuf());
  const std::unique_ptr<vpModelRenderer> small = vpModelRenderer::create(box);
  const std::string silent = told.str();
  const std::unique_ptr<vpModelRenderer> first = vpModelRenderer::create(box, vpModelRenderer::EGL);
  const std::unique_ptr<vpModelRenderer> second = vpModelRenderer::create(box, vpModelRenderer::EGL);
  const std::unique_ptr<vpModelRenderer> large = vpModelRenderer::create(makeSphere(0.1, 75));
  std::cerr.rdbuf(before);

  CHECK(silent.empty());
  CHECK(first->name() == "CPU");
  CHECK(second->name() == "CPU");
  CHECK(large->name() == "CPU");
  CHECK_THAT(told.str(), ContainsSubstring("Rendering on the CPU: ") && ContainsSubstring("EGL"));
  const std::string text = told.str();
  CHECK(std::count(text.begin(), text.end(), '\n') == 1);
  UNSCOPED_INFO(text);
  CHECK_THROWS_AS(vpEglRenderer(box), vpException);

  vpRenderedView view;
  first->render(vpHomogeneousMatrix(0., 0., 0.5, 0.1, 0.2, 0.3), makeCamera(), imageWidth, imageHeight,
                vpRenderOptions(), view);
  CHECK(coveredPixels(view) > 1000);
}
