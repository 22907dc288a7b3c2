// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchGridSolid_h
#define benchGridSolid_h

#include "generate/caoText.h"
#include "generate/syntheticObject.h"

#include <functional>

namespace bench {

/*!
  A solid made of the cells of a grid whose lines need not be evenly spaced.

  Neighbouring cells share whole sides, so its surface has no gaps and no corner of one triangle lies inside the side of
  another.
*/
class GridSolid
{
public:
  using Cell = std::array<int, 3>;
  //! A rectangle of the surface: the axis of its normal, the direction (1 or -1), and the solid cell behind it.
  struct Side
  {
    int axis = 0;
    int direction = 1;
    Cell cell;
    //! Corners counter-clockwise seen from outside; the first edge runs along axis + 1.
    std::array<Eigen::Vector3d, 4> corner;
    Eigen::Vector3d centre() const { return 0.5 * (corner[0] + corner[2]); }
  };
  using Color = std::function<Eigen::Vector3f(const Side &)>;

  //! \param lines Coordinates of the grid's planes along x, y and z, ascending, metres.
  //! \param isSolid Which cells there are.
  GridSolid(const std::array<std::vector<double>, 3> &lines, const std::function<bool(const Cell &)> &isSolid);

  const std::vector<Side> &sides() const { return m_sides; }

  //! Appends two triangles for each side. \param part Their material.
  void addTo(SyntheticObject &object, const Color &color, int part) const;

  /*!
    Appends a polygon for each connected plane piece of the surface.
    \param color Where it is given, pieces end where the colour changes too.
    \throw vpException where a piece has a hole: ViSP's polygons have none.
  */
  void addTo(CaoText &cao, const std::string &name, const Color &color = nullptr) const;

private:
  std::vector<Side> m_sides;
};

//! A box as a solid of one cell. \param centre, size Metres.
GridSolid boxSolid(const Eigen::Vector3d &centre, const Eigen::Vector3d &size);

//! Lines that divide [-size / 2, size / 2] at the given places. \param inner Metres, ascending.
std::vector<double> gridLines(double size, const std::vector<double> &inner = {});

} // namespace bench
#endif
