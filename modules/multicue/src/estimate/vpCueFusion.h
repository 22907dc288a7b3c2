// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCueFusion_h
#define vpCueFusion_h

#include "estimate/vpPosePrior.h"

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpMatrix.h>
#include <visp3/core/vpRobust.h>
#include <visp3/cues/vpPoseCue.h>

#include <deque>
#include <functional>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  The equations of several cues stacked for one minimisation ([P14] eq. 5, 12, 13).

  Each cue has its own robust estimator and scale. Its rows are divided by that scale, so that cues with other units, or
  other noise, count by what they know; [P14] divides by the number of rows instead, which makes a cue with few rows as
  strong as one with many. The scale of the first cue is taken out again: a cue alone is minimised in its own unit.
*/
class vpCueFusion
{
public:
  //! A cue and its rows.
  struct Part
  {
    int type = 0; //!< vpMbMultiCueTracker::vpTrackerType.
    const vpPoseCue *cue = nullptr;
    vpResidualBlock block;
    std::vector<double> weights; //!< Robust weights of the block's rows.
    double scale = 0.;           //!< That its errors were divided by.
    double factor = 1.;          //!< That its rows are multiplied by, as the user wants it.
  };
  //! ViSP's robust weights of a cue's errors.
  using Weigh = std::function<void(vpRobust &robust, const vpColVector &error, vpColVector &w)>;

  void clear()
  {
    m_count = 0;
    m_prior.clear();
    m_hides = false;
  }
  //! \param cue Matched; has to live until the next clear().
  void add(int type, const vpPoseCue &cue);

  //! What is known beforehand: its rows come last, and are not weighed. clear() forgets it.
  void setPrior(const vpPosePrior &prior) { m_prior = prior; }
  /*!
    Motions that outlines do not show: their interaction matrices lose them. clear() forgets it.
    \param visible Takes these motions out of small motions, object frame. \param seeing Type of the cue whose marks on
    the surface show them, \param allMarks those of all other cues do as well.
  */
  void setVisibleMotions(const vpPoseMatrix6 &visible, int seeing, bool allMarks)
  {
    m_visible = visible;
    m_seeing = seeing;
    m_allMarks = allMarks;
    m_hides = true;
  }
  //! True where a feature showed what setVisibleMotions() said that outlines do not.
  bool showsAll() const;
  //! \param factor Of a cue of that type, where it takes part; 1 by default.
  void setFactor(int type, double factor);
  //! Number of rows of the cues alone.
  unsigned int cueRows() const;

  //! Takes the cues' equations at a pose. \return Number of rows.
  unsigned int start(const vpHomogeneousMatrix &cMo);
  //! The equations at another pose. \param error, L Stacked, not scaled yet; their sizes fit already.
  void evaluate(const vpHomogeneousMatrix &cMo, vpColVector &error, vpMatrix &L);
  //! Robust weights \e w of each cue for itself; scales its rows of \e error and \e L.
  void weigh(const Weigh &weigh, vpColVector &error, vpMatrix &L, vpColVector &w);
  //! Keeps the weights for Part::weights.
  void keepWeights(const vpColVector &w);

  std::size_t size() const { return m_count; }
  const Part &operator[](std::size_t i) const { return m_parts[i].part; }
  //! \return The part of a type, null where it takes no part.
  const Part *find(int type) const;
  const vpPosePrior &prior() const { return m_prior; }
  //! Where the rows are of.
  const vpHomogeneousMatrix &pose() const { return m_pose; }
  //! \return Every row. \param use Called with each of them.
  template <typename Use> void forEachRow(const Use &use) const
  {
    for (std::size_t i = 0; i < m_count; ++i) {
      for (const vpResidual &row : m_parts[i].part.block.rows) {
        use(row);
      }
    }
    for (std::size_t i = 0; m_prior.isSet() && i < m_priorRows.size(); ++i) {
      use(m_priorRows[i]);
    }
  }

private:
  struct Memory // Is used again from frame to frame.
  {
    Part part;
    vpRobust robust;
    vpColVector error;
    vpColVector w;
  };

  bool isHidden(const Part &part, const vpResidual &row) const;
  void hide(const vpHomogeneousMatrix &cMo, Part &part) const;

  std::deque<Memory> m_parts; // Grows without copies, which of an empty vpColVector are undefined in ViSP 3.5.
  std::size_t m_count = 0;
  vpHomogeneousMatrix m_pose;
  bool m_hides = false;
  int m_seeing = 0;
  bool m_allMarks = false;
  vpPoseMatrix6 m_visible = vpPoseMatrix6::Identity();
  vpPosePrior m_prior;
  std::array<vpResidual, vpPosePrior::rows> m_priorRows;
};

END_VISP_NAMESPACE
#endif
