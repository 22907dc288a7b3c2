// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelColors_h
#define vpModelColors_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/cues/vpCueFrame.h>
#include <visp3/model/vpSurfaceSamples.h>
#include <visp3/model/vpTrackedModel.h>
#include <visp3/model/vpViewSphere.h>
#include <visp3/se3/vpPoseExponential.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

BEGIN_VISP_NAMESPACE

/*
  How well an image agrees with the colours that the model's file has, before anything was learnt from images: the
  correlation over places on the surface. Brightness is compared about its mean over places that face the same way, as
  the light on these is about the same, and the rest of the colours about its mean over all that is in view, as white
  may be any tint. Each of the two counts by its variance in the model as a share of that in the image: wrinkled foil
  and glints vary by much that the model's colours do not know.
*/
class vpModelColors
{
public:
  // Null for none.
  void setModel(std::shared_ptr<const vpTrackedModel> model);
  // The image that is looked at; has to live as long as agreement() is asked for.
  void setFrame(const vpCueFrame &frame, vpViewSphere &sphere, vpModelRenderer::Preference preference);
  // How much it tells, [0, 1]: 0 for a model without colours, or of one colour.
  double trust() const { return m_trusts[m_color != nullptr ? 1 : 0]; }
  // [-1, 1], about 0 by chance.
  double agreement(const vpHomogeneousMatrix &cMo) const { return agreement(vpPoseExponential::toEigen(cMo), 1); }
  // The same by one place in so many, for a first look.
  double agreement(const Eigen::Isometry3d &cMo, std::size_t every) const;

private:
  using Shade = std::array<float, 3>;
  // Places that face the same way have the same one.
  static constexpr std::size_t groups = 6 * 4 * 4;

  struct Place
  {
    Eigen::Vector3f position;
    Eigen::Vector3f normal;
    bool bothSides = false;
    std::size_t group = 0;
    Shade shade{};
    float weight = 0.F; // Number of renderings that it was seen in.
  };
  struct Sums;

  void learn(vpViewSphere &sphere, vpModelRenderer &renderer);
  void learnFrom(const vpRenderedView &view, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam);
  double deviation(bool hasColor) const;
  Shade shadeAt(int u, int v) const;

  std::shared_ptr<const vpTrackedModel> m_model;
  std::vector<Place> m_places;
  bool m_isLearnt = false;
  std::array<double, 2> m_trusts = {{0., 0.}}; // With gray images, and with coloured ones.
  const vpImage<unsigned char> *m_gray = nullptr;
  const vpImage<vpRGBa> *m_color = nullptr;
  vpCameraParameters m_camera;
};

END_VISP_NAMESPACE
#endif
