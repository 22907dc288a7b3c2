// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSurfaceShader_h
#define vpSurfaceShader_h

#include "vpCropCamera.h"

#include <visp3/model/vpModelRenderer.h>

BEGIN_VISP_NAMESPACE

/*!
  Fills the channels of a view that follow from knowing which triangle each pixel shows: face, normal and colour.
  All renderers only have to find depth and triangle, and give the same surface.
*/
class vpSurfaceShader
{
public:
  //! \param model Must outlive the shader.
  explicit vpSurfaceShader(const vpTrackedModel &model) : m_model(&model) {}

  /*!
    \param cMo, camera, channels Those of the rendering.
    \param triangles Per pixel of the crop, index of the triangle seen or -1.
    \param view Its channels are resized and filled; those that were not asked for become empty.
  */
  void shade(const vpHomogeneousMatrix &cMo, const vpCropCamera &camera, unsigned int channels,
             const std::vector<int> &triangles, vpRenderedView &view) const;

  //! Unlit colour of a triangle. \param weights Shares of its corners, sum 1.
  vpRGBa color(int triangle, const Eigen::Vector3d &weights) const;

private:
  class Patch;

  void shadeSurface(const vpPoseMatrix &pose, const vpCropCamera &camera, const std::vector<int> &triangles,
                    vpRenderedView &view) const;

  const vpTrackedModel *m_model;
};

END_VISP_NAMESPACE
#endif
