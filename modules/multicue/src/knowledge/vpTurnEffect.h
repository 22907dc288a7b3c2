// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTurnEffect_h
#define vpTurnEffect_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE

/*!
  How much an object looks different after a turn: foil and metal show what is around them, print stays what it is. The
  variance that the agreement with what was seen before the turn has beyond the one without a turn is taken to rise to a
  limit, which is the least squares fit to what was observed, the last turns most:
  \f[ v(\theta) = f g(\theta), \quad g(\theta) = \frac{\theta^2}{\theta^2 + \theta_0^2}, \quad
  f = \frac{\sum_i g(\theta_i) v_i}{\sum_i g(\theta_i)^2} \f]
*/
class vpTurnEffect
{
public:
  void reset() { *this = vpTurnEffect(); }
  //! \param angle Of a turn, radians. \param variance Squared difference from the usual agreement, beyond its variance.
  void observe(double angle, double variance)
  {
    const double share = shareOf(angle);
    m_products += share * std::min(std::max(variance, 0.), 1.) - forgetting * m_products;
    m_squares += share * share - forgetting * m_squares;
  }
  //! Variance after a turn by so many radians, beyond what print has.
  double variance(double angle) const
  {
    const double limit = (m_products + before * weight) / (m_squares + weight);
    return std::max(limit - ofPrint, 0.) * shareOf(angle);
  }

private:
  static constexpr double half = 0.35; // Radians, that have half of the effect.
  // Limits: of a printed box 0.1, of foil and bare metal 0.4 (rendered sequences). An object that was not turned yet is
  // taken for foil, as if that had been seen after so many turns by far.
  static constexpr double ofPrint = 0.12;
  static constexpr double before = 0.5;
  static constexpr double weight = 2.;
  static constexpr double forgetting = 0.02;

  static double shareOf(double angle) { return angle * angle / (angle * angle + half * half); }

  double m_products = 0.;
  double m_squares = 0.;
};

END_VISP_NAMESPACE
#endif
