// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelKeyframes_h
#define vpModelKeyframes_h

#include <visp3/cues/vpFrameSource.h>
#include <visp3/cues/vpKeyframes.h>
#include <visp3/model/vpViewSphere.h>

#include <memory>

BEGIN_VISP_NAMESPACE

/*
  Poses in an image by what the texture of the model's file looks like from all around: keyframes of renderings in place
  of trusted images. Nothing is found of a model without texture.
*/
class vpModelKeyframes
{
public:
  // Null for none.
  void setModel(std::shared_ptr<const vpTrackedModel> model);
  // Of all of the image. Renderings are made at the first call.
  std::vector<vpKeyframePose> find(const vpCueFrame &frame, vpViewSphere &sphere,
                                   vpModelRenderer::Preference preference);

  // Corners of the last image that agree with a pose.
  unsigned int agreeing(const vpHomogeneousMatrix &cMo) const { return m_isLearnt ? m_keyframes.agreeing(cMo) : 0; }

private:
  static constexpr unsigned int level =
      1; // Of a vpViewSphere: directions 32 degrees apart, so that one is near enough.
  void learn(vpViewSphere &sphere, vpModelRenderer &renderer);
  void learnView(const vpHomogeneousMatrix &cMo, vpModelRenderer &renderer);

  std::shared_ptr<const vpTrackedModel> m_model;
  vpKeyframes m_keyframes{vpViewSphere::size(level)};
  bool m_isLearnt = false;
};

END_VISP_NAMESPACE
#endif
