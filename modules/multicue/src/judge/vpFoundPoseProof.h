// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFoundPoseProof_h
#define vpFoundPoseProof_h

#include "knowledge/vpObjectKnowledge.h"

#include <memory>

BEGIN_VISP_NAMESPACE

//! Whether the pose where the object was found again is right: it may have shown sides that were never seen, and turn
//! to others.
class vpFoundPoseProof
{
public:
  //! \param known Before the object was found.
  void start(std::shared_ptr<const vpObjectKnowledge::Learnt> known, bool hasTexture);
  //! Looks at the surface at the pose that is followed. \return True where it turned out to be wrong.
  bool disproves(const vpHomogeneousMatrix &cMo, const vpObjectKnowledge &knowledge);
  //! How far the surface that was known before the object was found speaks for a pose, as a logarithm of odds.
  double surfaceEvidence(const vpHomogeneousMatrix &cMo, const vpObjectKnowledge &knowledge) const;
  //! How fast less agreement becomes the usual one. Not at all after a loss until the found pose is proved, or was
  //! followed for long: a wrong one that explains less would lower what it is measured by, and be believed for that.
  double fallRateOfUsual(unsigned int trustedFrames) const;

  const std::shared_ptr<const vpObjectKnowledge::Learnt> &known() const { return m_known; }
  bool isOpen() const { return m_isOpen; }
  //! True where the object was lost for that.
  bool hasFailed() const { return m_hasFailed; }

private:
  std::shared_ptr<const vpObjectKnowledge::Learnt> m_known;
  bool m_isOpen = false;
  unsigned int m_agreeing = 0;       // Frames in which what was known agreed with the image.
  unsigned int m_undecided = 0;      // In which it could not have told.
  unsigned int m_contradictions = 0; // In which it did not agree, on end.
  bool m_hasFailed = false;
};

END_VISP_NAMESPACE
#endif
