// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseMixtureSum_h
#define vpPoseMixtureSum_h

#include <visp3/se3/vpPoseMixture.h>

#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE

// A sum of weight * exp(-exponent) that neither over- nor underflows, and what may be left out of it.
class vpPoseMixture::Sum
{
public:
  // allowance: the logarithm of all weights' sum over the relative error.
  explicit Sum(double allowance) : m_allowance(allowance) {}

  void add(double exponent, double weight)
  {
    if (exponent < m_least) {
      m_sum = m_sum * std::exp(exponent - m_least) + weight;
      m_least = exponent;
      setLimit();
      return;
    }
    m_sum += weight * std::exp(m_least - exponent);
    if (m_sum > 1.5 * m_sumOfLimit) {
      setLimit();
    }
  }

  // Kernels whose exponents are above this come to less than the relative error of what is summed, all together.
  double limit() const { return m_limit; }
  double logarithm() const { return std::log(m_sum) - m_least; }

private:
  void setLimit()
  {
    m_sumOfLimit = m_sum;
    m_limit = m_allowance - logarithm();
  }

  double m_allowance;
  double m_least = std::numeric_limits<double>::infinity();
  double m_sum = 0.; // In units of exp(-m_least).
  double m_sumOfLimit = 0.;
  double m_limit = std::numeric_limits<double>::infinity();
};

END_VISP_NAMESPACE

#endif
