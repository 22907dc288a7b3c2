// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFallbackRenderer_h
#define vpFallbackRenderer_h

#include <visp3/model/vpModelRenderer.h>

#include <string>

BEGIN_VISP_NAMESPACE

//! Another renderer, until it fails: from then on, and for the very view that it failed at, the CPU renders. A GPU may
//! be taken away, or its driver started anew, while an object is tracked.
class vpFallbackRenderer : public vpModelRenderer
{
public:
  vpFallbackRenderer(std::unique_ptr<vpModelRenderer> renderer, std::shared_ptr<const vpTrackedModel> model);

  void render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
              unsigned int imageHeight, const vpRenderOptions &options, vpRenderedView &view) override;
  std::string name() const override { return m_renderer ? m_renderer->name() : m_cpu->name(); }
  std::string failure() const override { return m_failure; }

private:
  bool areDepthsOfModel(const vpHomogeneousMatrix &cMo, const vpRenderOptions &options,
                        const vpRenderedView &view) const;
  void fail(const std::string &reason);

  std::shared_ptr<const vpTrackedModel> m_model;
  std::unique_ptr<vpModelRenderer> m_renderer; // Null after a failure.
  std::unique_ptr<vpModelRenderer> m_cpu;      // Made when first needed.
  vpRenderedView m_compared;
  std::string m_failure;
};

END_VISP_NAMESPACE
#endif
