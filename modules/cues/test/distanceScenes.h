// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef distanceScenes_h
#define distanceScenes_h

#include <visp3/cues/vpFrameSource.h>
#include <visp3/cues/vpOrientedDistanceMap.h>
#include <visp3/se3/vpPoseRandom.h>

#include <catchMain.h>

#include <algorithm>
#include <cmath>

/*!
  \file distanceScenes.h
  Images with known edges, or none.
*/

namespace distanceScenes {
const vpCameraParameters camera(300., 300., 80., 60.);
const double farthest = vpOrientedDistanceSettings().maxDistance;

struct Shot
{
  explicit Shot(const vpImage<unsigned char> &image, const vpImage<bool> *mask = nullptr)
      : I(image), frame(source.frame(I, camera, mask)),
        whole(0, 0, static_cast<int>(I.getWidth()), static_cast<int>(I.getHeight()))
  {
  }

  vpImage<unsigned char> I;
  vpFrameSource source;
  vpCueFrame frame;
  vpImageRegion whole;
};

inline vpImage<unsigned char> halves(unsigned int rows, unsigned int columns, unsigned int border)
{
  vpImage<unsigned char> I(rows, columns, 60);
  for (unsigned int i = 0; i < rows; ++i) {
    for (unsigned int j = border; j < columns; ++j) {
      I[i][j] = 160;
    }
  }
  return I;
}

inline vpImage<unsigned char> noise(unsigned int rows, unsigned int columns, double mean, double deviation)
{
  vpPoseRandom random(7);
  vpImage<unsigned char> I(rows, columns);
  for (unsigned int k = 0; k < I.getSize(); ++k) {
    I.bitmap[k] = static_cast<unsigned char>(std::min(std::max(mean + deviation * random.normal(), 0.), 255.));
  }
  return I;
}

// A bright disc on dark ground.
inline vpImage<unsigned char> disc(unsigned int rows, unsigned int columns, double u, double v, double radius)
{
  vpImage<unsigned char> I(rows, columns);
  for (unsigned int i = 0; i < rows; ++i) {
    for (unsigned int j = 0; j < columns; ++j) {
      const double inside = std::min(std::max(radius - std::hypot(j - u, i - v) + 0.5, 0.), 1.);
      I[i][j] = static_cast<unsigned char>(40. + 120. * inside);
    }
  }
  return I;
}

inline double leastOf(const vpOrientedDistanceMap &map, double u, double v)
{
  double least = map.distance(u, v, 0);
  for (int bin = 1; bin < vpOrientedDistanceMap::bins; ++bin) {
    least = std::min(least, map.distance(u, v, bin));
  }
  return least;
}

} // namespace distanceScenes
#endif
