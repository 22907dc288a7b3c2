// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpLight_h
#define vpLight_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

//! How well a place of the image can show the contours that are there. What has no light is as black as the night sky
//! behind it: its contours are missing from the image, which does not speak against a pose that has them there.
namespace vpLight {
constexpr int reach = 3; //!< Pixels around a place, in which it may be seen.
//! What rows of dark places keep of their weight: after a large motion all of them may be beside the object.
constexpr double leastPull = 0.05;

//! \param brightest Gray level around a place. \param contrast Smallest one that counts, gray levels. \return 0 where
//! no contour can have that contrast, 1 from twice that on.
inline double at(double brightest, double contrast)
{
  return std::min(std::max(brightest / contrast - 1., 0.), 1.);
}

//! \return Weight of a row.
inline double pull(double light)
{
  return std::max(light, leastPull);
}

//! Mean over places, by their light. A quarter of them count in any case, with 0 where they are dark: a pose that has
//! all of its contours in the dark is not shown by the few that are not.
class Mean
{
public:
  void add(double value, double light)
  {
    m_sum += light * value;
    m_light += light;
    m_count += 1.;
  }
  //! 0 without places.
  double value() const { return m_count > 0. ? m_sum / std::max(m_light, leastShare * m_count) : 0.; }

private:
  static constexpr double leastShare = 0.25;
  double m_sum = 0.;
  double m_light = 0.;
  double m_count = 0.;
};
} // namespace vpLight

END_VISP_NAMESPACE
#endif
