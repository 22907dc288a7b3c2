// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpRankedPoses_h
#define vpRankedPoses_h

#include <visp3/multicue/vpPoseHypotheses.h>

#include <vector>

BEGIN_VISP_NAMESPACE

// The poses that minimisations led to, each once, with their probabilities.
class vpRankedPoses
{
public:
  // Without poses. \param contours That errors are of: each tells as much as one control point does, since its points
  // are wrong together.
  void start(std::size_t contours);
  // Adds a pose, unless it diverged or a better one moves the view's control points by less than the tolerance, pixels.
  // \param error Mean square of what it leaves unexplained, pixels. \param classes Those that it came from.
  void add(const vpHomogeneousMatrix &cMo, double error, const std::vector<int> &classes, const vpEdgeCue &edges,
           const vpModelView &view, double tolerance);
  // Brings them into the order of their probability.
  void rank();
  // A pose came to its end after it was ranked; its place stays the same until it is ranked again.
  void refine(std::size_t index, const vpHomogeneousMatrix &cMo, double error);
  // As they were ranked, the likeliest first.
  const std::vector<vpPoseHypothesis> &poses() const { return m_poses; }

private:
  struct Kept
  {
    vpPoseHypothesis pose;
    double motion = 0.; // Mean of the control points since the start, in search ranges.
    double cost = 0.;   // Negative logarithm of the probability.
  };
  void setError(Kept &kept, double error) const;

  std::size_t m_contours = 0;
  std::vector<Kept> m_kept; // Of each of the poses, in the same order.
  std::vector<vpPoseHypothesis> m_poses;
};

END_VISP_NAMESPACE
#endif
