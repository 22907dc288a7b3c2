// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMembership_h
#define vpMembership_h

#include <visp3/se3/vpCompatibility.h>

#include <array>
#include <cmath>

BEGIN_VISP_NAMESPACE

/*!
  How much a pixel belongs to the object: a(x) = (1 - erf(x / sqrt 2)) / 2, where x is its distance from the contour in
  units of the band s, and f(x) = -a'(x), the normal distribution's density.

  Read from a table and continued with the Taylor series of the third order, to 1e-8: erf() and exp() for every pixel at
  every iteration would take most of the cue's time.
*/
class vpMembership
{
public:
  struct Value
  {
    double a = 0.;
    double f = 0.;
  };

  static const vpMembership &table()
  {
    static const vpMembership membership;
    return membership;
  }

  Value operator()(double x) const
  {
    if (!(std::fabs(x) < limit)) {
      return {x < 0. ? 1. : 0., 0.};
    }
    const double place = (x + limit) * density + 0.5;
    const std::size_t node = static_cast<std::size_t>(place);
    const double x0 = static_cast<double>(node) / density - limit;
    const double h = x - x0;
    const Value &at = m_nodes[node];
    const double curve = x0 * x0 - 1.;
    return {at.a - at.f * h * (1. - 0.5 * h * x0 + h * h * curve / 6.),
            at.f * (1. - h * x0 + 0.5 * h * h * curve - h * h * h * x0 * (x0 * x0 - 3.) / 6.)};
  }

private:
  static constexpr double limit = 6.; // Beyond, a is 0 or 1 to 1e-9.
  static constexpr int density = 32;  // Nodes for each unit of x.

  vpMembership()
  {
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
      const double x = static_cast<double>(i) / density - limit;
      m_nodes[i] = {0.5 * std::erfc(x / std::sqrt(2.)), std::exp(-0.5 * x * x) / std::sqrt(2. * M_PI)};
    }
  }

  std::array<Value, 2 * 6 * density + 1> m_nodes;
};

END_VISP_NAMESPACE
#endif
