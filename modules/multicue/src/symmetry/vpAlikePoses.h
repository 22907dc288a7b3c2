// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpAlikePoses_h
#define vpAlikePoses_h

#include "estimate/vpModelLooks.h"
#include "judge/vpSituation.h"
#include "motion/vpObjectMotion.h"
#include "particles/vpTrackerParticles.h"
#include "symmetry/vpTrackerSymmetries.h"

BEGIN_VISP_NAMESPACE

//! Which poses count as one: those that look alike, and those that are near.
class vpAlikePoses
{
public:
  vpAlikePoses(const vpModelLooks &looks, const vpTrackerSymmetries &symmetries, const vpObjectMotion &motion,
               const vpSituation &situation, const vpTrackerParticles &particles)
      : m_looks(looks), m_symmetries(symmetries), m_motion(motion), m_situation(situation), m_particles(particles)
  {
  }

  //! Null where all poses look different.
  const vpModelSymmetries *symmetries() const { return m_symmetries.get(); }
  //! Of the poses that look like one, the nearest to where the object is believed to be.
  vpHomogeneousMatrix nearest(const vpHomogeneousMatrix &cMo) const
  {
    const vpHomogeneousMatrix &reference = m_situation.mustConfirm ? m_motion.trusted.cMo : m_motion.expected();
    return m_symmetries.get() == nullptr ? cMo : m_symmetries.nearest(cMo, reference, m_looks.model());
  }
  //! How far a pose is from another one, of those that look like it the nearest one; see
  //! vpTrackerParticles::distance(). The frame b is at the middle of the object's box.
  double distance(const vpHomogeneousMatrix &c1Mb, const vpHomogeneousMatrix &c2Mb) const
  {
    const double diameter = m_looks.model().diameter();
    if (m_symmetries.get() == nullptr) {
      return m_particles.distance(c1Mb, c2Mb, diameter);
    }
    const vpHomogeneousMatrix oMb = m_looks.centreFrame();
    const vpHomogeneousMatrix bMo = oMb.inverse();
    return m_particles.distance(m_symmetries.nearest(c1Mb * bMo, c2Mb * bMo, m_looks.model()) * oMb, c2Mb, diameter);
  }
  //! True where two poses are followed as one.
  vpPoseTracks::Same same() const
  {
    return [this, oMb = m_looks.centreFrame()](const vpHomogeneousMatrix &c1Mo, const vpHomogeneousMatrix &c2Mo) {
      return distance(c1Mo * oMb, c2Mo * oMb) < 1.;
    };
  }

private:
  const vpModelLooks &m_looks;
  const vpTrackerSymmetries &m_symmetries;
  const vpObjectMotion &m_motion;
  const vpSituation &m_situation;
  const vpTrackerParticles &m_particles; // Whose settings say how near one mode is.
};

END_VISP_NAMESPACE
#endif
