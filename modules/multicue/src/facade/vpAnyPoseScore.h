// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpAnyPoseScore_h
#define vpAnyPoseScore_h

#include <visp3/cues/vpColorCue.h>
#include <visp3/cues/vpEdgeCue.h>
#include <visp3/model/vpModelRenderer.h>
#include <visp3/model/vpModelView.h>

#include <memory>
#include <optional>

BEGIN_VISP_NAMESPACE

//! How likely one image makes any pose, by cues of its own, so that those of a tracker stay as they are. What it keeps
//! from call to call is memory alone, and no call depends on the ones before.
class vpAnyPoseScore
{
public:
  //! What a tracker looks with.
  struct Looks
  {
    std::shared_ptr<const vpTrackedModel> model;
    vpModelRenderer::Preference preference = vpModelRenderer::AUTOMATIC;
    vpModelViewOptions options;
    vpEdgeCueSettings edges;
    vpColorCueSettings colors;
    std::optional<vpColorCue::Reference> learnt; //!< Of the object's colours, where anything is known of them.
  };

  //! \param cMo Where the camera sees the object. \return Probability, see vpMbMultiCueTracker::score().
  double operator()(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const Looks &looks);

private:
  const vpModelView &viewAt(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const Looks &looks);
  //! \return Nothing where the colours that are known are not those of such images.
  static std::optional<double> evidenceOfColors(const vpCueFrame &frame, const vpModelView &view, const Looks &looks);

  std::unique_ptr<vpModelRenderer> m_renderer;
  std::shared_ptr<const vpTrackedModel> m_rendered; // Of the renderer.
  vpModelRenderer::Preference m_preference = vpModelRenderer::AUTOMATIC;
  std::unique_ptr<vpModelView> m_unseen; // What is derived from the model; no view was computed by it.
  std::unique_ptr<vpModelView> m_view;
};

END_VISP_NAMESPACE
#endif
