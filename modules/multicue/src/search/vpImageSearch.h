// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpImageSearch_h
#define vpImageSearch_h

#include "search/vpContourAligner.h"
#include "search/vpContourScan.h"
#include "search/vpImageStanding.h"
#include "search/vpModelKeyframes.h"

#include <visp3/multicue/vpDistanceRange.h>

#include <string>

BEGIN_VISP_NAMESPACE

/*
  Looks for an object of which nothing is known but its model in all of an image: at all places, from all sides, turned
  in the image by all angles, and at all distances of a range.

  What its contours look like from one side is added up at all places at once (vpContourScan), for sides 17 degrees
  apart, turns of 15 degrees and sizes that grow by a quarter. The best places of one size are aligned with the image's
  edges, and poses are drawn about the best of these in layers of less and less noise. So each size has its own best
  poses, which then compete with those of all others. Corners of a model that has a texture propose poses as well
  (vpModelKeyframes).

  Poses are compared by their standing: how much likelier the image is with the object there (vpImageStanding), and the
  corners that agree.
*/
class vpImageSearch
{
public:
  // How large the object may be: its diameter in the image, pixels.
  struct Sizes
  {
    double least = 0.;
    double most = 0.;
  };
  // \throw vpException where the object is too small in the image at all distances of the range.
  static Sizes sizes(const vpDistanceRange &distances, const vpTrackedModel &model, const vpCameraParameters &cam,
                     unsigned int height);
  static vpHomogeneousMatrix inTheMiddle(const vpTrackedModel &model, const vpCameraParameters &cam,
                                         const Sizes &sizes);

  void setModel(std::shared_ptr<const vpTrackedModel> model) { m_keyframes.setModel(std::move(model)); }
  // look: has the frame, and the model's colours where these are used. All have to live as long as the frame is asked
  // about.
  void setFrame(const vpCueFrame &frame, vpViewSphere &sphere, vpModelRenderer::Preference preference,
                const vpStartSearch &look);
  // Poses that look alike count as the same; null: none do. To live as long as the frame is asked about.
  void setSymmetries(const vpModelSymmetries *symmetries) { m_symmetries = symmetries; }
  // The best poses that are apart, best first.
  std::vector<vpPoseCandidate> find(const Sizes &sizes, std::uint64_t seed);
  // Of a pose in the frame in which was searched, a logarithm of odds.
  double standing(const vpHomogeneousMatrix &cMo) const { return standing(cMo, 1); }
  // What a pose lacks to be accepted, as a sentence; empty for nothing.
  std::string missing(const vpHomogeneousMatrix &cMo) const;

private:
  struct Place
  {
    Eigen::Isometry3d cMo = Eigen::Isometry3d::Identity();
    double score = 0.;
  };

  // Poses that are kept from the layer before, and those that are drawn about them.
  struct Layer
  {
    std::size_t parents;
    std::size_t children;
  };

  std::vector<Place> scan(double size);
  void addPlaces(const Eigen::Isometry3d &cMo, std::vector<Place> &places);
  vpPoseCandidate aligned(const Place &place) const;
  std::vector<vpPoseCandidate> bestOfSize(double size, std::uint64_t seed);
  std::vector<vpPoseCandidate> bestOfAll(const Sizes &sizes, std::uint64_t seed);
  vpPoseSearch searchFrom(const std::vector<vpPoseCandidate> &starts, std::uint64_t seed, std::size_t every) const;
  double rivalOf(const vpHomogeneousMatrix &cMo) const;
  void draw(vpPoseSearch &search, const vpPoseSearch::Spread &spread, const Layer &layer, bool isCoarse) const;
  double standing(const vpHomogeneousMatrix &cMo, std::size_t every) const;

  const vpCueFrame *m_frame = nullptr;
  const vpStartSearch *m_look = nullptr;
  vpViewSphere *m_sphere = nullptr;
  vpModelRenderer::Preference m_preference = vpModelRenderer::AUTOMATIC;
  vpOrientedDistanceMap m_edges;
  vpOrientedDistanceMap m_coarseEdges;
  vpContourScan m_scan;
  vpContourAligner m_aligner;
  vpContourAligner m_coarseAligner;
  vpModelKeyframes m_keyframes;
  vpImageStanding m_standing;
  const vpModelSymmetries *m_symmetries = nullptr;
  std::vector<vpPoseCandidate> m_rivals; // The best ones in the frame, of each size and of all.
};

END_VISP_NAMESPACE
#endif
