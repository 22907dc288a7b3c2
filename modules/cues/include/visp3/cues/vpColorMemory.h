// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpColorMemory_h
#define vpColorMemory_h

#include <visp3/model/vpTrackedModel.h>

#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_color
  Mean colours on both sides of the silhouette in the last trusted frame, by place on the object: rims of curved
  surfaces slide and their control points have no names, but what is near a place was near it a frame ago.
*/
class VISP_EXPORT vpColorMemory
{
public:
  //! Mean colours at a place, gray levels.
  struct Means
  {
    Eigen::Vector3f object = Eigen::Vector3f::Zero();
    Eigen::Vector3f background = Eigen::Vector3f::Zero();
  };

  //! Forgets everything.
  void clear();
  //! Places are those of \e model from now on; forgets everything where that is another one than before.
  void setModel(const vpTrackedModel &model);
  //! Starts a new trusted frame: what older ones left is forgotten.
  void beginFrame();
  //! Adds means at a place, object frame, metres. Means of places that are close together are averaged.
  void add(const Eigen::Vector3d &position, const Means &means);
  //! Adds how well the histograms told the contour at a place, see vpColorCue::evidence().
  void addEvidence(const Eigen::Vector3d &position, double evidence);
  //! \return Mean evidence at a place; \e unknown where there is none.
  double evidence(const Eigen::Vector3d &position, double unknown) const;
  //! \return False where nothing is known of a place. \param means Set where something is.
  bool find(const Eigen::Vector3d &position, Means &means) const;

private:
  struct Slot
  {
    std::uint32_t cell = 0;
    std::uint32_t frame = 0; // In use where it is the current one.
    float count = 0.F;
    Means sum;
    float evidenceCount = 0.F;
    float evidence = 0.F; // Sum.
  };

  std::uint32_t cellOf(const Eigen::Vector3d &position) const;
  // The slot of a cell, or the free one where it would go; -1 where the table is full.
  int slotOf(std::uint32_t cell) const;
  Slot *take(const Eigen::Vector3d &position);
  const Slot *look(const Eigen::Vector3d &position) const;

  std::vector<Slot> m_slots;
  std::uint32_t m_frame = 1;
  std::uint32_t m_used = 0;
  Eigen::Vector3d m_origin = Eigen::Vector3d::Zero();
  double m_cellSize = 0.; // Metres.
};

END_VISP_NAMESPACE
#endif
