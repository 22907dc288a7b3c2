// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef texturedShapes_h
#define texturedShapes_h

#include "modelShapes.h"

/*! \file texturedShapes.h Shapes with print on them. */

BEGIN_VISP_NAMESPACE
namespace texturedShapes {
using modelShapes::Point;
using modelShapes::Polygon;

//! A rectangle of texels [left, right) x [top, bottom).
struct Print
{
  unsigned int left, right, top, bottom;
  unsigned char gray;
};

inline vpImage<vpRGBa> printed(unsigned int width, unsigned int height, unsigned char ground,
                               const std::vector<Print> &prints)
{
  vpImage<vpRGBa> image(height, width, vpRGBa(ground, ground, ground, 255));
  for (const Print &print : prints) {
    for (unsigned int i = print.top; i < print.bottom; ++i) {
      for (unsigned int j = print.left; j < print.right; ++j) {
        image[i][j] = vpRGBa(print.gray, print.gray, print.gray, 255);
      }
    }
  }
  return image;
}

//! A parallelogram with an image on it: its upper left corner is the fourth one. \param image Of the builder, -1: none.
inline void addPicture(vpTrackedModelBuilder &builder, const Polygon &corners, int image)
{
  const std::array<Eigen::Vector2f, 4> uv = {
      {Eigen::Vector2f(0.F, 1.F), Eigen::Vector2f(1.F, 1.F), Eigen::Vector2f(1.F, 0.F), Eigen::Vector2f(0.F, 0.F)}};
  for (const std::array<std::size_t, 3> &triangle : {std::array<std::size_t, 3>{{0, 1, 2}}, {{0, 2, 3}}}) {
    std::array<vpTrackedModelBuilder::Corner, 3> c;
    for (std::size_t k = 0; k < 3; ++k) {
      c[k].position = corners[triangle[k]];
      c[k].texture = uv[triangle[k]];
    }
    builder.addTriangle(c, image);
  }
}

//! A box with the same picture on all sides.
inline void addPrintedBox(vpTrackedModelBuilder &builder, const Point &size, const vpImage<vpRGBa> &picture,
                          const Point &centre = Point::Zero())
{
  const int image = builder.addImage(picture);
  for (const Polygon &side : modelShapes::boxPolygons(size, centre)) {
    addPicture(builder, side, image);
  }
}
} // namespace texturedShapes
END_VISP_NAMESPACE
#endif
