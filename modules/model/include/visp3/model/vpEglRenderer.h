// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEglRenderer_h
#define vpEglRenderer_h

#include <visp3/model/vpModelRenderer.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_rendering
  Renders with OpenGL 3.3 core through EGL: no display server, on a GPU or on Mesa's software driver.

  Tries the EGL devices first, those with hardware before software ones, then Mesa's surfaceless platform. The context
  is made current for the length of a call, so several renderers and the application's own contexts live side by side.
*/
class VISP_EXPORT vpEglRenderer : public vpModelRenderer
{
public:
  //! \throw vpException naming the EGL or GL call that failed, or saying that the library was built without EGL.
  explicit vpEglRenderer(const std::shared_ptr<const vpTrackedModel> &model);
  ~vpEglRenderer() override;

  void render(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
              unsigned int imageHeight, const vpRenderOptions &options, vpRenderedView &view) override;
  std::string name() const override;

  //! True where Mesa renders in software (llvmpipe, softpipe, swrast).
  bool isSoftware() const;

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

END_VISP_NAMESPACE
#endif
