// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelLooks_h
#define vpModelLooks_h

#include "frame/vpFrameContext.h"
#include "motion/vpCentreFrame.h"

#include <visp3/cues/vpImageRegion.h>
#include <visp3/model/vpModelRenderer.h>
#include <visp3/model/vpModelView.h>

#include <memory>
#include <string>

BEGIN_VISP_NAMESPACE

//! What the model looks like in the camera's image at a pose: the contours of the last view, and depth. The visibility
//! of faces has hysteresis, so that the number and order of views count.
class vpModelLooks
{
public:
  void setModel(std::shared_ptr<const vpTrackedModel> model);
  const std::shared_ptr<const vpTrackedModel> &pointer() const { return m_model; }
  const vpTrackedModel &model() const { return *m_model; }
  //! \throw vpException before there is a model.
  const vpTrackedModel &requireModel() const;
  //! What draws the depth buffers that hide edges.
  void setPreference(vpModelRenderer::Preference preference);
  vpModelRenderer::Preference preference() const { return m_preference; }
  vpModelRenderer *renderer() const { return m_renderer.get(); }

  //! The image's camera, without distortion, and its size. \param image Of the frame that begins.
  void setImage(const vpCueFrame &image) { m_camera = image.camera(); }
  void setSize(unsigned int width, unsigned int height);
  const vpCameraParameters &camera() const { return m_camera; }
  unsigned int width() const { return m_width; } //!< Of the images since the start; 0 before it.
  unsigned int height() const { return m_height; }

  const vpModelView &view() const { return *m_view; }
  //! Poses that were tried may have seen other faces. \param before View whose faces go on.
  void continueFrom(const vpModelView &before) { m_view->continueFrom(before); }
  //! \param keepDepth What hides what is as in the last view.
  const vpModelView &compute(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, bool keepDepth = false);
  //! Keeps a view of this frame that is near enough. \param near Mean motion of the control points, pixels.
  const vpModelView &update(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, double near);
  //! A pose among others of the same frame.
  const vpModelView &computeNear(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  //! The same with control points that are farther apart by a factor.
  const vpModelView &computeCoarsely(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, double coarseness);

  //! Where in the image the object is looked for that is expected at a pose.
  vpImageRegion regionAround(const vpHomogeneousMatrix &cMo) const;
  //! Depth of the object's middle at a pose, metres.
  double depthOf(const vpHomogeneousMatrix &cMo) const;
  //! The frame with the object's orientation at the middle of its box.
  vpHomogeneousMatrix centreFrame() const { return vpCentreFrame(*m_model); }

  //! Why a renderer failed since this was asked last, as a sentence; empty where none did.
  std::string newFailure();

  //! Depth at a pose, for new points.
  const vpRenderedView &renderDepth(const vpHomogeneousMatrix &cMo);

  //! As they are set, and which of the texture's edges trusted frames left out.
  vpModelViewOptions options;

private:
  bool servesDepth(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo) const;

  std::shared_ptr<const vpTrackedModel> m_model;
  vpModelRenderer::Preference m_preference = vpModelRenderer::AUTOMATIC;
  std::unique_ptr<vpModelRenderer> m_renderer;
  std::unique_ptr<vpModelView> m_view;
  unsigned long long m_viewedFrame = 0;             // That the view is of.
  std::unique_ptr<vpModelRenderer> m_depthRenderer; // Of convex models, too; made when first needed.
  vpRenderedView m_depth;
  bool m_hasToldFailure = false;
  vpCameraParameters m_camera;
  unsigned int m_width = 0;
  unsigned int m_height = 0;
};

END_VISP_NAMESPACE
#endif
