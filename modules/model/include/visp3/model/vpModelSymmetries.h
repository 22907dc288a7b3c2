// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelSymmetries_h
#define vpModelSymmetries_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/model/vpTrackedModel.h>

#include <Eigen/Geometry>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_geometry
  A line about which an object may be turned by any angle and looks the same.
*/
struct vpSymmetryAxis
{
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); //!< Object frame; any length above 0.
  Eigen::Vector3d point = Eigen::Vector3d::Zero();      //!< A point of the line, object frame, metres.
};

/*!
  \ingroup group_model_geometry
  Motions after which an object looks as before, as BOP's data sets declare them: turns by certain angles, and lines
  about which every turn will do.

  With T one of them, the poses cMo and cMo T cannot be told apart by an image. The turns that are given are completed
  to a group: what follows from several of them one after the other is one of them, too. Two axes that are not parallel
  make a sphere: it looks the same after every turn about the point where they meet. Reflections are none of these
  motions.
*/
class VISP_EXPORT vpModelSymmetries
{
public:
  //! Largest number of turns, the identity among them; those together with every turn about an axis count once.
  static constexpr std::size_t mostDiscrete = 120;

  //! The object looks different from all sides.
  vpModelSymmetries();

  /*!
    Adds a turn, and all that follow from it and those before. One that is within 3 degrees of another is that one; the
    identity adds nothing.
    \param oTo Where the object is brought to, in its own frame, metres.
    \throw vpException where it is no rigid motion or turns the object by less than 3 degrees, where it moves an axis of
    the object elsewhere, and where more than mostDiscrete turns follow. What was added before then stays.
  */
  void addDiscrete(const vpHomogeneousMatrix &oTo);
  //! Adds an axis. \throw vpException where it has no direction, is not finite, or is moved elsewhere by a turn.
  void addAxis(const vpSymmetryAxis &axis);

  //! True where the object looks different from all sides.
  bool isEmpty() const { return m_discrete.size() == 1 && m_axes.empty(); }
  //! The turns by certain angles, the identity first; of those that differ by a turn about the axis, one.
  std::vector<vpHomogeneousMatrix> discrete() const;
  //! None, one, or, for a sphere, three through its middle; directions have unit length.
  const std::vector<vpSymmetryAxis> &axes() const { return m_axes; }
  //! True where a turn is one of the symmetries, to 3 degrees.
  bool contains(const vpHomogeneousMatrix &oTo) const;

  /*!
    Of all poses that look like \e cMo, the one nearest to another pose: the one with the least distance() of the two
    poses themselves. Exact, the angles about axes included.
    \param cMo A pose. \param reference Where it should be near to.
    \param centre Middle of the object, object frame, metres. \param radius Half of its size, metres, > 0.
  */
  vpHomogeneousMatrix nearest(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                              const Eigen::Vector3d &centre, double radius) const;
  //! Root of the mean squared distance between the two places of the points of a sphere that moves with the object,
  //! metres. \param centre, radius Of the sphere.
  static double distance(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &reference,
                         const Eigen::Vector3d &centre, double radius);

private:
  using Turns = std::vector<Eigen::Isometry3d>;

  bool isSphere() const { return m_axes.size() > 1; }
  bool isSame(const Eigen::Isometry3d &a, const Eigen::Isometry3d &b) const;
  bool isKnown(const Turns &turns, const Eigen::Isometry3d &turn) const;
  bool keepsAxis(const Eigen::Isometry3d &turn) const;
  Turns completed(const Turns &generators) const;
  Eigen::Isometry3d turned(const Eigen::Isometry3d &pose, const Eigen::Isometry3d &reference,
                           const Eigen::Vector3d &centre, double weight) const;

  Turns m_discrete;
  std::vector<vpSymmetryAxis> m_axes;
};

/*!
  \ingroup group_model_geometry
  How alike a model has to be to itself.
*/
struct VISP_EXPORT vpSymmetryOptions
{
  double tolerance = 0.01;     //!< How far surface and edges may be apart, in diameters, (0, 0.1].
  unsigned int mostTurns = 12; //!< Largest n of the turns by 360 / n degrees that are looked for, [2, 100].
  double colorTolerance = 0.1; //!< How far colours may be apart in each channel, of [0, 1], [0, 1].

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_model_geometry
  Finds the symmetries of a model: turns that bring its surface, its edges and, where the model has any, its colours
  back onto themselves.

  Axes are looked for through the centroid of the surface: principal axes, the axes of the frame, the normals of planar
  faces, and along, to the middles and to the ends of edges. What the model does not tell is not asked: a .cao file has
  no colours, so the printed box that it stands for is found to look the same after half a turn. Features smaller than
  the tolerance are not seen either. Find symmetries only of objects whose model says all of their looks.

  A surface without edges is found to have the axes of its principal moments and of the frame alone.

  \return None where the model has neither surface nor edges, or names texture images that could not be read.
  \throw vpException naming the option that is out of range.
*/
VISP_EXPORT vpModelSymmetries vpFindSymmetries(const vpTrackedModel &model,
                                               const vpSymmetryOptions &options = vpSymmetryOptions());

END_VISP_NAMESPACE
#endif
