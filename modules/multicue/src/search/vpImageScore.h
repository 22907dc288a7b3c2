// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpImageScore_h
#define vpImageScore_h

#include "judge/vpSituation.h"
#include "knowledge/vpObjectKnowledge.h"
#include "search/vpContourAligner.h"
#include "search/vpContourScan.h"
#include "search/vpPoseScore.h"
#include "search/vpPoseSearch.h"

#include <visp3/cues/vpColorOddsMap.h>
#include <visp3/cues/vpOrientedDistanceMap.h>
#include <visp3/model/vpViewSphere.h>

#include <memory>

BEGIN_VISP_NAMESPACE

//! Maps of one image, and what they say of a pose in microseconds.
class vpImageScore
{
public:
  vpImageScore(vpModelLooks &looks, vpCueSet &cues, vpObjectKnowledge &knowledge, const vpSituation &situation)
      : m_looks(looks), m_cues(cues), m_knowledge(knowledge), m_situation(situation)
  {
  }

  //! Another model.
  void setModel() { m_sphere.reset(); }
  void forgetImages() { m_wholeFrame = 0; }
  //! Views from all around; made when first needed.
  vpViewSphere &sphere();

  //! Looks at all of the image.
  void setFrame(const vpFrameContext &frame);
  //! At a part of it.
  void setRegion(const vpFrameContext &frame, const vpImageRegion &region);
  //! True where all of this image is looked at already.
  bool hasWhole(const vpFrameContext &frame) const { return m_wholeFrame == frame.image.number(); }
  //! How much each cue counts. \param byEdges In a search in which others are hardly trusted.
  void weigh(bool byEdges);

  const vpPoseScore &score() const { return m_score; }
  vpPoseScore::Value operator()(const vpHomogeneousMatrix &cMo) const { return m_score(cMo); }
  //! Share of the object's outline at a pose that is in the image; it need not be looked at.
  double insideShare(const vpHomogeneousMatrix &cMo);
  static constexpr double insideToConfirm = 0.4; //!< Such a share tells the pose.

  //! From poses drawn far and wide to a few that are as good as they can be told from views made beforehand.
  void settle(vpPoseSearch &search);
  void settleByScore(vpPoseSearch &search) const;

  const vpOrientedDistanceMap &distances() const { return m_distances; }
  const vpColorOddsMap &odds() const { return m_odds; }
  vpContourScan &contourScan() { return m_contourScan; }

private:
  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpObjectKnowledge &m_knowledge;
  const vpSituation &m_situation;

  std::unique_ptr<vpViewSphere> m_sphere;
  vpOrientedDistanceMap m_distances;
  vpColorOddsMap m_odds;
  vpPoseScore m_score;
  vpContourAligner m_aligner;
  vpContourScan m_contourScan;
  unsigned long long m_wholeFrame = 0;
};

END_VISP_NAMESPACE
#endif
