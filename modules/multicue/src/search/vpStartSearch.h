// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpStartSearch_h
#define vpStartSearch_h

#include "search/vpModelColors.h"
#include "search/vpPoseSearch.h"

#include <visp3/cues/vpOrientedDistanceMap.h>
#include <visp3/multicue/vpWeightedPose.h>

BEGIN_VISP_NAMESPACE

/*
  Looks for an object of which nothing was learnt yet about poses that may be its: by the model's edges, and its colours
  where it has any. What the same search finds elsewhere in the image tells what clutter explains.
*/
class vpStartSearch
{
public:
  // What speaks for a pose.
  struct Value
  {
    double edges = 0.;  // 1 where the model's edges are, 0 where no edge is.
    double colors = 0.; // Correlation with the model's colours, about 0 by chance.
    double inside = 0.; // Share of the outline in the image.
    double seen = 0.;   // Mean of both, as far as the model's colours tell poses apart.
    double total = -1.; // The same, less what is outside the image.
  };
  void setModel(std::shared_ptr<const vpTrackedModel> model) { m_colors.setModel(std::move(model)); }
  void setFrame(const vpCueFrame &frame, vpViewSphere &sphere, vpModelRenderer::Preference preference, bool usesColors);
  // The best ones that are apart, best first.
  std::vector<vpPoseCandidate> find(const std::vector<vpWeightedPose> &starts, const vpPoseSearch::Spread &spread,
                                    std::uint64_t seed) const;
  // What the best poses elsewhere in the image have: of as many places.
  std::vector<Value> clutter(const vpHomogeneousMatrix &cMo, const vpPoseSearch::Spread &spread, std::uint64_t seed,
                             std::size_t places) const;
  Value operator()(const vpHomogeneousMatrix &cMo) const;
  // Correlation with the model's colours by one place in so many.
  double colorsAt(const Eigen::Isometry3d &cMo, std::size_t every) const { return m_colors.agreement(cMo, every); }
  double trust() const { return m_usesColors ? m_colors.trust() : 0.; }

private:
  vpPoseSearch search(const std::vector<vpWeightedPose> &starts, const vpPoseSearch::Spread &spread, std::uint64_t seed,
                      std::size_t draws, std::size_t offspring, bool byColors) const;

  bool m_usesColors = false;
  vpOrientedDistanceMap m_edges;
  vpPoseScore m_score;
  vpModelColors m_colors;
  vpViewSphere *m_sphere = nullptr;
  vpCameraParameters m_camera;
  double m_width = 0.;
  double m_height = 0.;
};

END_VISP_NAMESPACE
#endif
