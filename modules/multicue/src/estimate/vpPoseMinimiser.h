// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseMinimiser_h
#define vpPoseMinimiser_h

#include "cues/vpCueSet.h"
#include "estimate/vpCueFusion.h"
#include "estimate/vpModelLooks.h"
#include "estimate/vpServoing.h"
#include "symmetry/vpTrackerSymmetries.h"

BEGIN_VISP_NAMESPACE

//! One virtual visual servoing ([P14] eq. 5): the pose at which cues that are matched agree best with the image.
class vpPoseMinimiser
{
public:
  //! \param servoing Has to outlive this.
  explicit vpPoseMinimiser(vpServoing &servoing) : m_servoing(servoing) {}

  //! Which equations the next minimisation has.
  struct Equations
  {
    int cues = 0; //!< Of those in use.
    const vpPosePrior *prior = nullptr;
  };
  /*!
    \param equations Which. \param cMo Pose to begin at, and the result; it stays where there are too few rows.
    \return False where there are too few rows.
  */
  bool minimise(const vpFrameContext &frame, const Equations &equations, vpCueSet &cues,
                const vpTrackerSymmetries &symmetries, double diameter, vpHomogeneousMatrix &cMo);
  //! The cues' equations at a pose, all believed, as after a minimisation.
  void takeAsTheyAre(const std::vector<vpCueSet::Used> &cues, const vpHomogeneousMatrix &cMo);

  //! The equations of the last minimisation.
  const vpCueFusion &fusion() const { return m_fusion; }
  void clear() { m_fusion.clear(); }
  const vpMatrix &chosenMotions() const { return m_servoing.chosenMotions(); }

  //! For vpMbTracker's virtual functions of the same purpose.
  void start(const std::map<int, double> &factors);
  void evaluate() { m_fusion.evaluate(m_servoing.pose(), m_servoing.error(), m_servoing.interaction()); }

private:
  bool iterate(double diameter);
  bool restrictToObserved(double diameter);
  void step(unsigned int iteration, bool allMotions);
  double imageMotion(double diameter) const;

  vpServoing &m_servoing;
  vpCueFusion m_fusion;
  vpServoing::Step m_step;
  double m_residual = 0.; // Root of the weighted mean square error.
  double m_focal = 1.;    // Pixels.
};

END_VISP_NAMESPACE
#endif
