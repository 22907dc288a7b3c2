// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourEvidence_h
#define vpContourEvidence_h

#include <visp3/cues/vpEdgeCue.h>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  What an image shows of the contours of a pose, for a comparison with another one.

  Two poses of an object that is nearly symmetric have most of their contours at the same places: means over all of them
  hardly differ, the less so as the pose that shows less has less to miss. What tells which is right is what only one of
  them has. With the agreement a of each place, its weight l, by its light, and the sums over places that the other pose
  has no contour at: \f[ D = \sum_{own} l (a - \tfrac{1}{2}) - \sum_{other} l (a - \tfrac{1}{2}) \f]
  A place by itself has an agreement or has none, so the sum is off by the root of their number N by chance, and in the
  same way frame after frame: only what is beyond that counts, \f$ |D| - \tfrac{1}{2} \sqrt{N} \f$.
*/
class vpContourEvidence
{
public:
  //! Sum over images from which on one of two poses is the right one, as a logarithm of odds.
  static constexpr double decisiveOdds = 10.;

  //! \param edges As they were matched near the pose.
  void set(const vpEdgeCue &edges, const vpHomogeneousMatrix &cMo);
  //! D beyond chance, in places. It is for the other pose (below 0) only where most of what that one has alone is
  //! there: what hides the object takes contours away, and shows none.
  double advantageOver(const vpContourEvidence &other) const;
  //! \param advantage In places. \return What it says in one image, as a logarithm of odds: far below what it would be
  //! for each place by itself, since neighbours are alike, and limited, since images on end are.
  static double oddsOf(double advantage);

private:
  struct Place
  {
    Eigen::Vector2f pixel;
    Eigen::Vector2f normal;
    float agreement;
    float weight;
  };
  //! Sums over what the other one has not.
  struct Own
  {
    double weight = 0.;
    double agreement = 0.;
  };
  Own withoutThoseOf(const vpContourEvidence &other) const;
  bool has(const Place &place) const;

  std::vector<Place> m_places; // From left to right.
};

END_VISP_NAMESPACE
#endif
