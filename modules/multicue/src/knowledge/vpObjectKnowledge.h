// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpObjectKnowledge_h
#define vpObjectKnowledge_h

#include "estimate/vpModelLooks.h"
#include "judge/vpAgreement.h"
#include "knowledge/vpPastKnowledge.h"
#include "knowledge/vpTurnEffect.h"
#include "motion/vpObjectMotion.h"

#include <visp3/cues/vpKeyframes.h>
#include <visp3/cues/vpSurfaceMemory.h>

BEGIN_VISP_NAMESPACE

//! What trusted frames taught of the object: what it looks like, and how well cues agree with a right pose. Cues
//! remember more by themselves.
class vpObjectKnowledge
{
public:
  //! What was known at one time.
  struct Learnt
  {
    std::array<vpCueReference, vpCueKinds::most> cues; //!< Of those in use then, in the order of vpCueKinds.
    vpSurfaceMemory::Reference surface;
    vpAgreement usual;
    vpObjectMotion::Trusted trusted;
    unsigned int period = 0; //!< How often the object had been found again.
  };

  //! What a right pose has at least, whatever the frames before had.
  static constexpr double leastUsual = 0.4;
  //! A surface of one colour tells no pose from another, and has no corners.
  static constexpr double leastTexture = 0.15;
  //! Evidence that wrong poses have in the median after an image was shifted by 20 to 126 pixels: on ViSP's cube, its
  //! teabox and its castle -0.76, -0.97 and -1.1. Right ones have 1.33, 0.33 and 1.31 there (vpEdgeCue::evidence()).
  static constexpr double evidenceByChance = -1.;

  void setModel(const vpTrackedModel &model, const std::vector<vpSurfaceSample> &samples);
  //! A start.
  void forgetImages(double now);

  //! A cue's agreement as a share of the usual one, as far as it counts: one cue alone does not make a pose better than
  //! those before, nor refuse it.
  static double countedShare(double value, double usual);
  //! How much a cue counts whose agreement with trusted poses has this variance, in shares of the usual one: 1 for one
  //! that is steady. Colours that come and go with the light on the object say little.
  static double reliability(double variance);
  //! Share of the surface that is known and tells poses apart.
  static double weightOf(const vpSurfaceMemory::Agreement &seen);
  //! True where colours come and go with the light.
  bool hasUnsteadyColors() const;
  bool hasTexture() const { return surface.texture() > leastTexture; }
  //! Evidence of edges alone, as a share of that of the trusted frames before, both beyond what chance has.
  double shareOfEvidence(double evidence) const;
  //! Of the surface's agreement with what was learnt before a turn by so many radians, as a share of the usual one.
  double surfaceVariance(double turn) const { return unsteadiness.surface + m_turnEffect.variance(turn); }
  //! What the surface adds to the logarithm of the odds of a pose, beyond what all cues explain together.
  double surfaceOdds(const vpSurfaceMemory::Agreement &seen, double variance) const;
  //! True where the surface differs so much from what is known of it that the pose can hardly be right.
  bool isRefutedBy(const vpSurfaceMemory::Agreement &seen, double variance) const;
  //! True where no surface whose agreement has this variance could contradict a pose.
  static bool tellsNothing(double variance);
  //! How far the object is turned from where it was seen before the loss, radians.
  double turnSince(const vpHomogeneousMatrix &cMo, const vpObjectMotion &motion) const;
  //! What cues say of a pose, with what the keyframes say of it.
  double explainedBy(const vpCueShare &cues, const vpHomogeneousMatrix &cMo) const;

  //! From a trusted pose. \param fallRate How fast less agreement becomes the usual one.
  void learnUsual(const vpAgreement &agreement, double fallRate);
  static constexpr double fallRate = 0.02;
  //! What the start shows of itself is more than other images show of the object.
  void learnUsualOfStart(const vpAgreement &atStart, const vpCueSet &cues);
  //! The surface at a trusted pose, from the frame that it was given.
  void learnSurface(const vpHomogeneousMatrix &cMo, vpModelLooks &looks);
  //! Keeps what a trusted pose shows, for the frames in which nothing near the expected pose fits.
  void learnKeyframe(const vpCueFrame &image, const vpHomogeneousMatrix &cMo, vpModelLooks &looks, bool isStart);
  //! The pose that was given may be a little off: the first frame that is tracked replaces what was learnt there.
  void expectKeyframe() { m_keyframeIsProvisional = true; }

  Learnt now(const vpCueSet &cues, const vpObjectMotion::Trusted &trusted) const;
  //! Goes back to what was learnt. How steady the cues are is not forgotten: it takes long to be known, and a drift
  //! changes it little.
  void recall(const Learnt &learnt, vpCueSet &cues);
  //! After a trusted frame. \param value Of the pose, see vpJudgedPose.
  void keep(double value, const vpCueSet &cues, const vpObjectMotion &motion);
  //! What was learnt since the object was found may be of a wrong pose.
  void forgetPeriod();
  void beginPeriod() { ++m_period; }

  vpSurfaceMemory surface;
  vpKeyframes keyframes;
  unsigned int mostAgreeing = 0; //!< Features of keyframes with one pose, in this frame.
  vpAgreement usual;             //!< Mean over the trusted frames.
  vpAgreement unsteadiness;      //!< Variance of its share of the usual one over the trusted frames.
  vpPastKnowledge<std::shared_ptr<const Learnt>> past;
  double lastExplained = 0.; //!< When a trusted frame was explained well, seconds.

private:
  void learnTurnEffect(const vpHomogeneousMatrix &cMo);

  bool m_keyframeIsProvisional = false; // Of the start, whose pose may be a little off.
  unsigned int m_period = 0;            // How often the object was found again.
  vpTurnEffect m_turnEffect;            // On the surface.
  std::size_t m_turns = 0;              // That it was learnt from.
};

END_VISP_NAMESPACE
#endif
