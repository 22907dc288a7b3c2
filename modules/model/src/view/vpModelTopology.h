// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelTopology_h
#define vpModelTopology_h

#include "mesh/normalCone.h"

#include <visp3/model/vpTrackedModel.h>

BEGIN_VISP_NAMESPACE

/*!
  What the views of a model derive from it once: edges linked into chains, on which side of an edge its faces lie, and
  which smooth triangles are neighbours.
*/
class vpModelTopology
{
public:
  //! An edge of a chain, walked from its first vertex to its second one, or backwards.
  struct Link
  {
    int edge = -1;
    bool reversed = false;
  };
  //! Edges that follow one another without a corner.
  struct Chain
  {
    int first = 0; //!< Index into links().
    int count = 0;
  };

  explicit vpModelTopology(const vpTrackedModel &model);

  const std::vector<Chain> &chains() const { return m_chains; }
  const std::vector<Link> &links() const { return m_links; }
  /*!
    Parallel to vpTrackedModel::edgeFaces(): unit direction, in the face and perpendicular to the edge, from the edge
    into the face; zero where it is not known.
  */
  const std::vector<Eigen::Vector3d> &intoFace() const { return m_intoFace; }

  //! A corner normal n at vertex v of a smooth triangle, in the form that tells fast where it faces: n and n v.
  struct Facings
  {
    std::vector<float> x, y, z;
    std::vector<float> offset;
  };
  const Facings &facings() const { return m_facings; }
  //! For corner k of smooth triangle i at [i][k]: its index in facings().
  const std::vector<std::array<int, 3>> &facingCorners() const { return m_facingCorners; }
  //! Smooth triangles that are near one another, and their corner normals.
  struct Patch
  {
    std::vector<int> triangles;
    vpMeshDetail::NormalCone normals;
  };
  const std::vector<Patch> &patches() const { return m_patches; }
  //! What tells on which side of a rim a smooth triangle turns away, all of it in one place of the memory.
  struct Slope
  {
    Eigen::Vector3d corner;                   //!< The first one.
    std::array<Eigen::Vector3d, 2> gradients; //!< Of the shares of the second and third corner, up to a factor.
    bool oriented;                            //!< As its face.
  };
  const std::vector<Slope> &slopes() const { return m_slopes; }
  //! For corner k of smooth triangle i at [i][k]: the smooth triangle across the side from corner k to corner k + 1, or
  //! -1.
  const std::vector<std::array<int, 3>> &neighbours() const { return m_neighbours; }

private:
  void linkEdges(const vpTrackedModel &model);
  void walkChain(const vpTrackedModel &model, int edge, const std::vector<std::vector<int>> &edgesAt,
                 std::vector<char> &used);
  void findSides(const vpTrackedModel &model);
  void collectFacings(const vpTrackedModel &model);
  void findSlopes(const vpTrackedModel &model);
  void findPatches(const vpTrackedModel &model);
  void joinSmoothTriangles();

  std::vector<Chain> m_chains;
  std::vector<Link> m_links;
  std::vector<Eigen::Vector3d> m_intoFace;
  Facings m_facings;
  std::vector<std::array<int, 3>> m_facingCorners;
  std::vector<Patch> m_patches;
  std::vector<Slope> m_slopes;
  std::vector<std::array<int, 3>> m_neighbours;
};

END_VISP_NAMESPACE
#endif
