// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchMeshError_h
#define benchMeshError_h

#include "generate/syntheticObject.h"

namespace bench {

//! \return The triangles with all edges halved until none is longer than \e length, metres. Triangles that shared an
//! edge still do.
std::vector<ColoredTriangle> subdivide(std::vector<ColoredTriangle> triangles, double length);

/*!
  What a reconstruction would make of an object: its edges are round, its surface uneven by 0.5 % of the diameter, and
  it is 1 % too large or too small. Its frame stays. \param strength Multiplies these errors, > 0. \param seed Of the
  unevenness, and of the size.
*/
std::vector<ColoredTriangle> reconstructed(const std::vector<ColoredTriangle> &triangles, double strength,
                                           std::uint64_t seed);

} // namespace bench
#endif
