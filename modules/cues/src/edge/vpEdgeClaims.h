// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEdgeClaims_h
#define vpEdgeClaims_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  Shares edges of an image among the model edges that take them for theirs.

  An edge of the image is evidence of one edge of the model. Where two that run side by side take the same one, since
  the other is not seen, each of them would pull the pose to where both of them are on it: a plate that turns up from
  its edge would stay on edge. So what is found counts for a model edge by how near it was to it when it was looked for:
  with distances d_j of all that take it, \f$ e^{-d / s} / \sum_j e^{-d_j / s} \f$, s = 0.7 pixels.
  Edges that go on where others end, as those of a round outline, are no rivals: they take other stretches.
*/
class vpEdgeClaims
{
public:
  //! What was found for a control point.
  struct Claim
  {
    int edge = 0;          //!< Of the model; those of the same one, all with a negative number included, are no rivals.
    Eigen::Vector2f place; //!< In the image, pixels.
    Eigen::Vector2f normal; //!< Of the model edge there, unit length.
    float distance = 0.F;   //!< Of the place from the model edge, pixels.
    float length = 0.F;     //!< Of the stretch of the model edge that the point stands for, pixels.
  };

  explicit vpEdgeClaims(std::size_t number) { m_claims.reserve(number); }
  void add(const Claim &claim) { m_claims.push_back(claim); }
  //! Of each claim, once all are added: (0, 1], in their order.
  std::vector<float> shares();

private:
  static constexpr int none = -1;
  static constexpr std::size_t slots = 1024; // Of the table of cells.
  static constexpr int mostRivals = 7;       // Edges, beside the claim's own.

  // The claim of another edge that is nearest along this one.
  struct Rival
  {
    int edge;
    float along;
    float distance;
  };
  struct Rivals
  {
    std::array<Rival, mostRivals> edges;
    int count = 0;
    void add(const Rival &rival);
  };

  static std::size_t slotOf(int column, int row);
  void addRivals(const Claim &claim, int first, Rivals &rivals) const;
  float shareOf(const Claim &claim) const;

  std::vector<Claim> m_claims;
  std::array<int, slots> m_first{}; // Claim in each cell.
  std::vector<int> m_next;          // Claim in the same cell as this one.
};

END_VISP_NAMESPACE
#endif
