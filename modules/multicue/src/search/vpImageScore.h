// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpImageScore_h
#define vpImageScore_h

#include "judge/vpSituation.h"
#include "knowledge/vpObjectKnowledge.h"
#include "search/vpContourAligner.h"
#include "search/vpContourScan.h"
#include "search/vpPoseScore.h"
#include "search/vpPoseSearch.h"
#include "search/vpViewMaker.h"

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
  void setModel();
  //! Where views are kept for the next start of the program; empty: nowhere. Of spheres that are made from now on.
  void setViewCache(const std::string &folder) { m_viewCache = folder; }
  const std::string &viewCache() const { return m_viewCache; }
  //! Before a frame. \param isTimed It has a deadline: views are made beside the frames from now on, and those that are
  //! not made yet are done without. Otherwise each is made when first looked at.
  void prepare(bool isTimed);
  void forgetImages() { m_wholeFrame = 0; }
  //! Views from all around, for one who makes those that are missing.
  vpViewSphere &sphere();

  //! Looks at all of the image.
  void setFrame(const vpFrameContext &frame);
  //! The same for a search. \return False where it is put off: too little time is left, or too few views are made.
  bool setFrameInTime(const vpFrameContext &frame);
  //! At a part of it.
  void setRegion(const vpFrameContext &frame, const vpImageRegion &region);
  //! True where all of this image is looked at already.
  bool hasWhole(const vpFrameContext &frame) const { return m_wholeFrame == frame.image.number(); }
  //! True where colours were known when the image was looked at: they may have been learnt, or forgotten, since.
  bool hasColors() const { return m_hasColors; }
  //! How much each cue counts. \param byEdges In a search in which others are hardly trusted.
  void weigh(bool byEdges);

  const vpPoseScore &score() const { return m_score; }
  vpPoseScore::Value operator()(const vpHomogeneousMatrix &cMo) const { return m_score(cMo); }
  //! Share of the object's outline at a pose that is in the image; it need not be looked at.
  double insideShare(const vpHomogeneousMatrix &cMo);
  static constexpr double insideToConfirm = 0.4; //!< Such a share tells the pose.

  //! From poses drawn far and wide to a few that are as good as they can be told from views made beforehand.
  //! \param share Of the poses that are drawn around the best ones on the way.
  void settle(vpPoseSearch &search, double share = 1.);
  void settleByScore(vpPoseSearch &search, double share = 1.) const;

  const vpOrientedDistanceMap &distances() const { return m_distances; }
  const vpColorOddsMap &odds() const { return m_odds; }
  vpContourScan &contourScan() { return m_contourScan; }

private:
  void makeSphere();
  void loadViews();
  void setLevel(unsigned int level);

  vpModelLooks &m_looks;
  vpCueSet &m_cues;
  vpObjectKnowledge &m_knowledge;
  const vpSituation &m_situation;

  std::string m_viewCache;
  std::unique_ptr<vpViewSphere> m_sphere;
  std::unique_ptr<vpViewMaker> m_maker; // Of the sphere, so that it ends before it.
  unsigned int m_level = 0;             // The finest one that may be looked at.
  vpOrientedDistanceMap m_distances;
  vpColorOddsMap m_odds;
  vpPoseScore m_score;
  vpContourAligner m_aligner;
  vpContourScan m_contourScan;
  unsigned long long m_wholeFrame = 0;
  bool m_hasColors = false; // The aligner and the score have a map of them.
};

END_VISP_NAMESPACE
#endif
