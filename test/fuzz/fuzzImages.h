// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fuzzImages_h
#define fuzzImages_h

#include "fuzzBytes.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <memory>

namespace fuzz {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! Images of the object, and images of anything else.
class Images
{
public:
  //! \param cMo Where the tracker's object is shown, where it is.
  vpImage<vpRGBa> draw(Bytes &bytes, unsigned int width, unsigned int height, const vpHomogeneousMatrix &cMo,
                       const vpMbMultiCueTracker &tracker)
  {
    const unsigned int kind = bytes.choice(8);
    vpImage<vpRGBa> I(height, width, vpRGBa(60, 90, 70));
    if (kind < 5 && width > 0 && height > 0) {
      showObject(I, cMo, tracker);
    } else if (kind == 5) {
      fillWithNoise(I, bytes.byte());
    } else if (kind == 6) {
      fillWithSquares(I, 1 + bytes.choice(20));
    } else {
      I = vpRGBa(bytes.byte(), bytes.byte(), bytes.byte());
    }
    return I;
  }

private:
  void showObject(vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpMbMultiCueTracker &tracker)
  {
    const std::shared_ptr<const vpTrackedModel> model = tracker.getModel();
    if (!model) {
      return;
    }
    if (model != m_model) {
      m_renderer = std::make_unique<vpCpuRenderer>(model);
      m_model = model;
    }
    vpCameraParameters cam;
    tracker.getCameraParameters(cam);
    vpRenderOptions options;
    options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL;
    try {
      m_renderer->render(cMo, cam, I.getWidth(), I.getHeight(), options, m_view);
    } catch (const vpException &) { // A pose that is none.
      return;
    }
    for (int i = 0; i < m_view.height; ++i) {
      for (int j = 0; j < m_view.width; ++j) {
        const std::size_t at =
            static_cast<std::size_t>(i) * static_cast<std::size_t>(m_view.width) + static_cast<std::size_t>(j);
        if (m_view.depth[at] > 0.F) {
          const auto level = static_cast<unsigned char>(120.F - 100.F * m_view.normal[at].z() * m_view.normal[at].z());
          I[static_cast<unsigned int>(m_view.top + i)][static_cast<unsigned int>(m_view.left + j)] =
              vpRGBa(static_cast<unsigned char>(250 - level), level, 40);
        }
      }
    }
  }

  static void fillWithNoise(vpImage<vpRGBa> &I, std::uint32_t seed)
  {
    std::uint32_t state = seed;
    for (unsigned int i = 0; i < I.getSize(); ++i) {
      state = state * 1664525U + 1013904223U;
      I.bitmap[i] = vpRGBa(static_cast<unsigned char>(state >> 24U), static_cast<unsigned char>(state >> 16U),
                           static_cast<unsigned char>(state >> 20U));
    }
  }

  static void fillWithSquares(vpImage<vpRGBa> &I, unsigned int side)
  {
    for (unsigned int i = 0; i < I.getHeight(); ++i) {
      for (unsigned int j = 0; j < I.getWidth(); ++j) {
        I[i][j] = (i / side + j / side) % 2 == 0 ? vpRGBa(20, 20, 20) : vpRGBa(230, 220, 200);
      }
    }
  }

  std::shared_ptr<const vpTrackedModel> m_model;
  std::unique_ptr<vpCpuRenderer> m_renderer;
  vpRenderedView m_view;
};
} // namespace fuzz

#endif
