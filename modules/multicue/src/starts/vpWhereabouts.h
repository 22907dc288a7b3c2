// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpWhereabouts_h
#define vpWhereabouts_h

#include "judge/vpFoundPoseProof.h"
#include "judge/vpSituation.h"
#include "starts/vpRoughStart.h"
#include "symmetry/vpHalfTurns.h"

BEGIN_VISP_NAMESPACE

//! Where a lost object may be, and how unlikely a pose is by that.
class vpWhereabouts
{
public:
  vpWhereabouts(const vpModelLooks &looks, const vpObjectMotion &motion, const vpSituation &situation,
                const vpFoundPoseProof &proof, const vpHalfTurns &halfTurns, const vpRoughStart &rough)
      : m_looks(looks), m_motion(motion), m_situation(situation), m_proof(proof), m_halfTurns(halfTurns), m_rough(rough)
  {
  }

  //! Where it was trusted last, and before that, and where it went on to from there.
  std::vector<vpHomogeneousMatrix> poses() const;
  //! Where a search begins.
  const vpObjectMotion::Trusted &searchOrigin() const;
  //! The same, and where the object went on to from there.
  std::array<vpHomogeneousMatrix, 3> fromOrigin() const;
  double depthOfOrigin() const { return m_looks.depthOf(searchOrigin().cMo); }
  //! How far a pose is from the last trusted one: 1 for half a turn or two diameters.
  double changeSince(const vpHomogeneousMatrix &cMo) const;
  //! Its depth beside that of the last trusted one, or one that a hint or a detector gave, [0, 1].
  double depthChange(const vpHomogeneousMatrix &cMo) const;

private:
  const vpModelLooks &m_looks;
  const vpObjectMotion &m_motion;
  const vpSituation &m_situation;
  const vpFoundPoseProof &m_proof;
  const vpHalfTurns &m_halfTurns;
  const vpRoughStart &m_rough;
};

END_VISP_NAMESPACE
#endif
