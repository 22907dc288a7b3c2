// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPlaceProjection_h
#define vpPlaceProjection_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/se3/vpCompatibility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

BEGIN_VISP_NAMESPACE

// Of a place in the image at half resolution.
struct vpSeenPlace
{
  std::size_t number; // Of the place.
  int pixel;          // Counted row by row.
  float u, v;
  float depth;
  float facing; // Cosine between normal and line of sight.
};

/*
  Where places of the surface are in the image at half resolution, for one pose.

  A block of them at a time, so that nothing is allocated: first all numbers, in a loop that compilers turn into vector
  instructions, then those of the places that are seen.
*/
class vpPlaceProjection
{
public:
  // Numbers of a place: position, normal, and 1 where it is seen from its back as well (else 0).
  static constexpr std::size_t arrays = 7;

  // width, height: of the image at half resolution; cam: of the whole one.
  vpPlaceProjection(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, int width, int height);

  // Calls visit(vpSeenPlace) for each place that is seen. places: the arrays, count numbers each, one after the other.
  template <typename Visitor> void forEachSeen(const float *places, std::size_t count, Visitor &&visit)
  {
    for (std::size_t first = 0; first < count; first += most) {
      const std::size_t end = std::min(most, count - first);
      project(places + first, count, end);
      for (std::size_t i = 0; i < end; ++i) {
        vpSeenPlace place;
        if (look(i, places[6 * count + first + i] > 0.F, place)) {
          place.number = first + i;
          visit(place);
        }
      }
    }
  }

private:
  // Places of a block.
  static constexpr std::size_t most = 128;
  // Places that are seen at a grazing angle show what is beside them.
  static constexpr float leastFacing = 0.2F;

  void project(const float *first, std::size_t stride, std::size_t count);

  bool look(std::size_t i, bool bothSides, vpSeenPlace &place) const
  {
    place.facing = bothSides ? std::fabs(m_facing[i]) : m_facing[i];
    if (!(place.facing > leastFacing && m_depth[i] > 0.F)) {
      return false;
    }
    place.u = m_u[i];
    place.v = m_v[i];
    if (!(place.u > -0.5F && place.v > -0.5F && place.u < m_right && place.v < m_bottom)) {
      return false;
    }
    place.depth = m_depth[i];
    place.pixel = static_cast<int>(place.v + 0.5F) * m_width + static_cast<int>(place.u + 0.5F);
    return true;
  }

  float m_pose[12];
  float m_px, m_py, m_u0, m_v0; // Of the image at half resolution.
  int m_width;
  float m_right, m_bottom;
  std::array<float, most> m_u, m_v, m_depth;
  std::array<float, most> m_facing, m_distance;
};

END_VISP_NAMESPACE
#endif
