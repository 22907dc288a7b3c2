// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEdgeEstimator_h
#define vpEdgeEstimator_h

#include "estimate/vpEstimate.h"
#include "estimate/vpPoseMinimiser.h"

#include <visp3/multicue/vpPoseHypotheses.h>

#include <cmath>

BEGIN_VISP_NAMESPACE

//! Brings edges alone to a start, and finds the poses that several edge hypotheses allow ([T10] III).
class vpEdgeEstimator
{
public:
  vpEdgeEstimator(vpModelLooks &looks, vpCueSet &cues, vpPoseMinimiser &minimiser,
                  const vpTrackerSymmetries &symmetries)
      : m_looks(looks), m_cues(cues), m_minimiser(minimiser), m_symmetries(symmetries)
  {
  }

  void setSettings(const vpPoseHypothesisSettings &settings);
  void forgetImages();
  void startFrame() { m_minimisations = 0; }

  //! From where hypotheses lead, where they are on, else from the pose itself.
  vpEstimate estimate(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  //! From the pose itself. \param isMatched The last match serves it.
  vpEstimate from(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, bool isMatched);
  //! The pose that the best hypothesis leads to from a start, or that.
  vpHomogeneousMatrix propose(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);

  //! A view at a pose, and edges matched there.
  void match(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  //! The same for a pose among others of the same frame.
  void matchNear(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  void matchView(const vpFrameContext &frame);
  //! The poses that the last match at a pose allows. \param limit Of minimisations, 0: as set. \param decisive A
  //! residue that ends the search, pixels. \return False where there is none.
  bool findPoses(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo, unsigned int limit, double decisive);
  //! Matches a hypothesis at its own pose and minimises it there, again while it moves. \return True where the last
  //! match serves it.
  bool refine(const vpFrameContext &frame, std::size_t index, unsigned int most);
  //! True where the last match serves a pose, too.
  bool serves(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo) const;
  //! Hypotheses take only motions that edges can show: outlines do not show turns about an axis of the shape.
  void restrictMotions();
  //! The same, of those that the user chose.
  vpPoseMatrix6 freeMotions() const;

  const vpPoseHypotheses &hypotheses() const { return m_hypotheses; }
  const std::vector<vpPoseHypothesis> &found() const { return m_hypotheses.hypotheses(); }
  void clearHypotheses() { m_hypotheses.clear(); }
  //! Of the best pose hypothesis, pixels; infinite where there is none.
  double bestResidue() const { return found().empty() ? HUGE_VAL : found().front().residue; }
  //! What a pose may leave unexplained, pixels.
  double explainedResidue() const;
  //! True where a pose leaves no more unexplained than the trusted ones before it.
  bool explains(double residue) const { return residue < explainedResidue(); }
  //! Takes the best hypothesis of a trusted frame for what is usual.
  void learnResidue();
  void forgetResidue() { m_usualResidue = 0.; }
  //! In the last frame.
  unsigned int minimisations() const { return m_minimisations; }
  void setMinimisations(unsigned int number) { m_minimisations = number; }

private:
  struct Proposal
  {
    vpHomogeneousMatrix cMo;
    bool isMatched = false; // The last match serves it.
  };
  Proposal proposal(const vpFrameContext &frame, const vpHomogeneousMatrix &cMo);
  Proposal best(const vpFrameContext &frame);
  Proposal reachFarther(const vpFrameContext &frame, const vpHomogeneousMatrix &start, const vpHomogeneousMatrix &near);
  bool searchFarther(const vpFrameContext &frame, const vpHomogeneousMatrix &start);
  unsigned int minimisationsLeft() const;

  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpPoseMinimiser &m_minimiser;
  const vpTrackerSymmetries &m_symmetries;

  vpPoseHypotheses m_hypotheses;
  vpPoseHypotheses m_other;         // Those of the near search while a farther one goes on.
  double m_usualResidue = 0.;       // Of the best hypothesis in trusted frames, pixels; 0: none yet.
  unsigned int m_minimisations = 0; // In the last frame.
  vpMatrix m_motions;               // Scratch memory.
};

END_VISP_NAMESPACE
#endif
