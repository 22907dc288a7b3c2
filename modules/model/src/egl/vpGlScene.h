// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpGlScene_h
#define vpGlScene_h

#include "vpGlFramebuffer.h"
#include "vpGlProgram.h"

#include "../render/vpCropCamera.h"

#include <array>
#include <vector>

BEGIN_VISP_NAMESPACE

//! A model on the GPU and what draws it. Made, used and destroyed while one and the same context is current.
class vpGlScene
{
public:
  explicit vpGlScene(const vpTrackedModel &model);

  //! Fills \e view.depth, and \e triangle where it is not null, with view.width x view.height pixels.
  void render(const vpHomogeneousMatrix &cMo, const vpCropCamera &camera, double nearDistance, vpRenderedView &view,
              std::vector<int> *triangle);
  //! As vpGlObject::abandon().
  void abandon()
  {
    m_program.abandon();
    m_vertexArray.abandon();
    m_positions.abandon();
    m_indices.abandon();
    m_framebuffer.abandon();
  }

private:
  using Box = std::array<Eigen::Vector3d, 2>;

  void upload(const vpTrackedModel &model);
  Eigen::Matrix4f objectToClip(const vpPoseMatrix &pose, const vpCropCamera &camera, double nearDistance,
                               const vpRenderedView &view) const;

  vpGlProgram m_program;
  GLint m_objectToClip;
  vpGlVertexArray m_vertexArray;
  vpGlBuffer m_positions;
  vpGlBuffer m_indices;
  vpGlFramebuffer m_framebuffer;
  GLsizei m_indexCount = 0;
  Box m_box;
};

END_VISP_NAMESPACE
#endif
