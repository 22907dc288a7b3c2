// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseSearch_h
#define vpPoseSearch_h

#include "frame/vpFrameDeadline.h"
#include "search/vpContourAligner.h"
#include "search/vpPoseScore.h"

#include <visp3/model/vpModelSymmetries.h>
#include <visp3/multicue/vpWeightedPose.h>
#include <visp3/se3/vpPoseExponential.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

BEGIN_VISP_NAMESPACE

// A pose that was looked at.
struct vpPoseCandidate
{
  vpHomogeneousMatrix cMo;
  double score = -HUGE_VAL; // Nobody looked at it.
};

/*
  Draws poses where a score is high, in layers of less and less noise: from a few starts, or from all around the object.
  Poses turn about the middle of the object's box.
*/
class vpPoseSearch
{
public:
  // How far around its starts a search goes.
  struct Spread
  {
    double translation = 0.1; // Deviation, in diameters.
    double rotation = 0.3;    // Deviation, radians.
    double depth = 0.1;       // Deviation along the line of sight, in diameters.

    Spread halved() const { return {0.5 * translation, 0.5 * rotation, 0.5 * depth}; }
    // Wider for an object that was not seen for some time; beyond half of its size and all turns nothing is gained.
    Spread grown(double factor) const
    {
      return {std::min(translation * factor, 0.6), std::min(rotation * factor, 2.), std::min(depth * factor, 0.8)};
    }
  };
  // Around an expected pose, where the image does not look as it should.
  static constexpr Spread near() { return {0.12, 0.35, 0.15}; }
  // Poses that differ by less than this are refined to the same one.
  static constexpr Spread same() { return {0.05, 0.15, 0.1}; }
  // How much less likely poses are that are several spreads off.
  enum class Tail
  {
    LIGHT, // As of one that was told with its deviation.
    HEAVY  // As of an object that may have jumped.
  };

  // The larger, the likelier.
  using Score = std::function<double(const vpHomogeneousMatrix &cMo)>;

  vpPoseSearch(const vpPoseScore &score, const vpTrackedModel &model, std::uint64_t seed);
  vpPoseSearch(const Score &score, const vpTrackedModel &model, std::uint64_t seed);

  // Until then poses are aligned and looked at. Those that nobody looked at are never among the best.
  void setLimit(const vpTimeLimit &limit) { m_limit = limit; }
  // True where poses were left out.
  bool isCutShort() const { return m_isCutShort; }
  // Poses of the first layer, without a score; the starts are among them.
  void scatter(const std::vector<vpHomogeneousMatrix> &starts, const Spread &spread, std::size_t number);
  // Likewise about several poses, of each as many as it has a share in all weights.
  void scatter(const std::vector<vpWeightedPose> &starts, const Spread &spread, std::size_t number);
  // Poses near to one of these are likelier than those far from them; before the first score().
  void setPrior(const std::vector<vpHomogeneousMatrix> &poses, const Spread &spread, Tail tail);
  // Poses that look alike count as the same; null: none do. To live as long as the search.
  void setSymmetries(const vpModelSymmetries *symmetries) { m_symmetries = symmetries; }
  // Orientations all around, at a point of the line of sight through a pixel; see spread for depth and translation.
  void scatterAround(const Eigen::Vector3d &centre, const vpHomogeneousMatrix &cMo, const Spread &spread,
                     std::size_t number);
  // Where there is a limit, brings the candidates into any order: so many of each source are left out.
  void mix();
  // Keeps all candidates as they are, to be added again after they were aligned.
  void keepCopies() { m_copies = m_candidates; }
  void addCopies();
  // Lets all of them slide to where their silhouettes, one point of so many, separate the colours.
  void alignByColors(const vpContourAligner &aligner, double reach, unsigned int steps, std::size_t every = 1);
  void alignByEdges(const vpContourAligner &aligner, unsigned int steps);
  // Those from this one on.
  void score(std::size_t first = 0);
  // Keeps the best ones that are apart from each other, and draws around these with half of the noise. \return How many
  // were kept: those after them have no score.
  std::size_t breed(const Spread &spread, std::size_t keep, std::size_t number);
  // Keeps the best ones that are apart from each other, and draws around these with less and less noise.
  void anneal(Spread spread, std::size_t keep, std::size_t number, unsigned int layers);
  // The best one first.
  const std::vector<vpPoseCandidate> &candidates() const { return m_candidates; }
  std::size_t scored() const { return m_scored; }
  // Those that are less than one spread from a better one are left out, a shift along the line of sight counted by the
  // depth's; at most keep are left.
  void keepBest(std::size_t keep, const Spread &apart);
  // Of two poses, in spreads.
  double distance(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b, const Spread &unit) const;

private:
  template <typename Step> void align(unsigned int steps, Step &&step);
  double scoreOf(const vpHomogeneousMatrix &cMo);
  bool isOver();
  vpHomogeneousMatrix draw(const vpHomogeneousMatrix &cMo, const Spread &spread);

  Score m_score;
  const vpModelSymmetries *m_symmetries = nullptr;
  Eigen::Vector3d m_centre;
  double m_diameter;
  std::uint64_t m_seed;
  std::uint64_t m_draws = 0;
  std::size_t m_scored = 0;
  std::vector<vpPoseCandidate> m_candidates;
  std::vector<vpPoseCandidate> m_copies;
  std::vector<vpHomogeneousMatrix> m_priorPoses;
  Spread m_priorSpread;
  Tail m_priorTail = Tail::LIGHT;
  vpTimeLimit m_limit;
  bool m_isCutShort = false;
};

END_VISP_NAMESPACE
#endif
