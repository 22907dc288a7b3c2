// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchShadowMap_h
#define benchShadowMap_h

#include <visp3/model/vpCpuRenderer.h>

#include <Eigen/Core>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {

//! What a far light sees of an object: surface behind that lies in shadow.
class ShadowMap
{
public:
  //! \param model Not null. A convex one has no shadows, and nothing is rendered.
  explicit ShadowMap(const std::shared_ptr<const vpTrackedModel> &model);

  //! \param toLight Unit vector, camera frame.
  void update(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &toLight);

  //! Share of the light that arrives at a surface point, [0, 1]. \param point, normal Camera frame.
  float lit(const Eigen::Vector3f &point, const Eigen::Vector3f &normal) const;

private:
  float litAt(int column, int row, float depth) const;

  std::shared_ptr<const vpTrackedModel> m_model;
  vpCpuRenderer m_renderer;
  vpRenderedView m_view;
  double m_extent = 0.; //!< Of the model, metres.
  float m_focal = 0.F;
  float m_texel = 0.F;           //!< Size on the object, metres.
  Eigen::Matrix3f m_rotation;    //!< From camera to light.
  Eigen::Vector3f m_translation; //!< From camera to light, metres.
};

} // namespace bench
#endif
