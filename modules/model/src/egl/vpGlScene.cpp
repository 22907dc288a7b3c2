// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpGlScene.h"
#include "vpGlShaders.h"

#include <algorithm>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
template <class T> void fillBuffer(GLenum target, const vpGlBuffer &buffer, const std::vector<T> &values)
{
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
  vpCheckGl("glBufferData");
}

struct DepthRange
{
  double nearest;
  double farthest;
};

//! What the z-buffer has to resolve: the box's depths, a little more for rounding, and nothing before the near plane.
DepthRange depthRange(const std::array<Eigen::Vector3d, 2> &box, const vpPoseMatrix &pose, double nearDistance)
{
  constexpr double slack = 0.01;
  DepthRange range = {std::numeric_limits<double>::infinity(), 0.};
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d position(box[corner & 1U].x(), box[(corner >> 1U) & 1U].y(), box[corner >> 2U].z());
    const double depth = vpTransform(pose, position).z();
    range.nearest = std::min(range.nearest, depth);
    range.farthest = std::max(range.farthest, depth);
  }
  range.nearest = std::max(range.nearest * (1. - slack), nearDistance);
  range.farthest = std::max(range.farthest, range.nearest) * (1. + slack);
  return range;
}
} // namespace

vpGlScene::vpGlScene(const vpTrackedModel &model)
    : m_program(vpGlVertexShader, vpGlFragmentShader), m_objectToClip(m_program.uniform("objectToClip")),
      m_box({{model.boxMin(), model.boxMax()}})
{
  upload(model);
  glUseProgram(m_program.id());
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DITHER);
  vpCheckGl("glEnable(GL_DEPTH_TEST)");
}

void vpGlScene::upload(const vpTrackedModel &model)
{
  std::vector<Eigen::Vector3f> positions;
  positions.reserve(model.vertices().size());
  for (const Eigen::Vector3d &vertex : model.vertices()) {
    positions.push_back(vertex.cast<float>());
  }
  std::vector<std::array<int, 3>> indices;
  indices.reserve(model.triangles().size());
  for (const vpModelTriangle &triangle : model.triangles()) {
    indices.push_back(triangle.vertex);
  }
  m_indexCount = static_cast<GLsizei>(3 * indices.size());
  glBindVertexArray(m_vertexArray.id());
  fillBuffer(GL_ARRAY_BUFFER, m_positions, positions);
  fillBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices, indices);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector3f), nullptr);
  glEnableVertexAttribArray(0);
  vpCheckGl("glVertexAttribPointer");
}

Eigen::Matrix4f vpGlScene::objectToClip(const vpPoseMatrix &pose, const vpCropCamera &camera, double nearDistance,
                                        const vpRenderedView &view) const
{
  // Crop pixel x is OpenGL's window coordinate x + 0.5, and row 0 its lowest, which is also the first one read back.
  const DepthRange z = depthRange(m_box, pose, nearDistance);
  const double depth = z.farthest - z.nearest;
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  projection(0, 0) = 2. * camera.fx / view.width;
  projection(0, 2) = 2. * (camera.cx + 0.5) / view.width - 1.;
  projection(1, 1) = 2. * camera.fy / view.height;
  projection(1, 2) = 2. * (camera.cy + 0.5) / view.height - 1.;
  projection(2, 2) = (z.farthest + z.nearest) / depth;
  projection(2, 3) = -2. * z.farthest * z.nearest / depth;
  projection(3, 2) = 1.;
  Eigen::Matrix4d cMo = Eigen::Matrix4d::Identity();
  cMo.topRows<3>() = pose;
  return (projection * cMo).cast<float>();
}

void vpGlScene::render(const vpHomogeneousMatrix &cMo, const vpCropCamera &camera, double nearDistance,
                       vpRenderedView &view, std::vector<int> *triangle)
{
  m_framebuffer.begin(view.width, view.height, triangle != nullptr);
  const Eigen::Matrix4f matrix = objectToClip(vpToPoseMatrix(cMo), camera, nearDistance, view);
  glUniformMatrix4fv(m_objectToClip, 1, GL_FALSE, matrix.data());
  glDrawElements(GL_TRIANGLES, m_indexCount, GL_UNSIGNED_INT, nullptr);
  vpCheckGl("glDrawElements");
  m_framebuffer.readDepth(view.width, view.height, view.depth.data());
  if (triangle) {
    m_framebuffer.readTriangle(view.width, view.height, triangle->data());
  }
}

END_VISP_NAMESPACE
