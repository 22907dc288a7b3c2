// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpNormalEquations_h
#define vpNormalEquations_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Cholesky>

BEGIN_VISP_NAMESPACE

//! Normal equations of a weighted least squares, without the coefficients that are not used.
template <int Order> struct vpNormalEquations
{
  Eigen::Matrix<double, Order, Order> A = 1e-6 * Eigen::Matrix<double, Order, Order>::Identity();
  Eigen::Matrix<double, Order, 1> b = Eigen::Matrix<double, Order, 1>::Zero();

  template <typename Basis> void add(const Basis &basis, double offset, double weight)
  {
    for (int i = 0; i < Order; ++i) {
      const double scaled = weight * basis(i);
      b(i) += scaled * offset;
      for (int j = 0; j <= i; ++j) {
        A(i, j) += scaled * basis(j);
      }
    }
  }
  template <typename Mean> void solve(Mean &mean) const
  {
    mean.setZero();
    mean.template head<Order>() = A.template selfadjointView<Eigen::Lower>().llt().solve(b);
  }
};

END_VISP_NAMESPACE
#endif
