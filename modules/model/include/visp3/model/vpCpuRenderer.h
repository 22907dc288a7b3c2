// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCpuRenderer_h
#define vpCpuRenderer_h

#include <visp3/model/vpModelRenderer.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_rendering
  Renders with a z-buffer of its own: needs nothing, is exact, and is the reference that the tests compare EGL with.
*/
class VISP_EXPORT vpCpuRenderer : public vpModelRenderer
{
public:
  explicit vpCpuRenderer(const std::shared_ptr<const vpTrackedModel> &model);
  ~vpCpuRenderer() override;

  void render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
              unsigned int imageHeight, const vpRenderOptions &options, vpRenderedView &view) override;
  std::string name() const override;
  bool mayChangeThread() const override { return true; }

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

END_VISP_NAMESPACE
#endif
