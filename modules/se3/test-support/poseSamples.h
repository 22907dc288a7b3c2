// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef poseSamples_h
#define poseSamples_h

#include <visp3/se3/vpPoseExponential.h>
#include <visp3/se3/vpPoseRandom.h>

#include <cmath>
#include <vector>

/*!
  \file poseSamples.h
  Elements of SE(3) on which the properties are tested: the places where formulas break, and random ones.
*/

inline vpPoseTangent tangentOf(const Eigen::Vector3d &v, const Eigen::Vector3d &omega)
{
  vpPoseTangent xi;
  xi << v, omega;
  return xi;
}

inline std::vector<vpPoseTangent> awkwardTangents()
{
  const Eigen::Vector3d v(0.3, -0.2, 1.5);
  const std::vector<Eigen::Vector3d> axes = {{1., 0., 0.},     {0., -1., 0.},     {0., 0., 1.}, {0.6, -0.8, 0.},
                                             {0.6, 0.8, 1e-9}, {1e-5, 1., -1e-7}, {1., 1., -1.}};
  const std::vector<double> angles = {0.,   1e-12, 1e-8, 1e-5, 2.4e-4,      2.6e-4,      9.9e-4,      1.01e-3,
                                      0.02, 0.5,   1.57, 2.5,  M_PI - 1e-2, M_PI - 1e-4, M_PI - 1e-7, M_PI - 1e-10};
  std::vector<vpPoseTangent> tangents = {vpPoseTangent::Zero(), vpPoseTangent::Constant(1e-8)};
  for (const Eigen::Vector3d &axis : axes) {
    for (const double angle : angles) {
      tangents.push_back(tangentOf(v, angle * axis.normalized()));
      tangents.push_back(tangentOf(1e-8 * v, angle * axis.normalized()));
    }
  }
  vpPoseRandom random(1);
  for (int i = 0; i < 50; i++) {
    vpPoseTangent xi = random.normalTangent();
    xi.tail<3>() *= random.uniform() * M_PI / xi.tail<3>().norm();
    tangents.push_back(xi);
  }
  return tangents;
}

//! \return The largest absolute difference of two poses' matrices.
inline double maxDifference(const vpHomogeneousMatrix &aMb, const vpHomogeneousMatrix &aMc)
{
  return (vpPoseExponential::toEigen(aMb).matrix() - vpPoseExponential::toEigen(aMc).matrix()).cwiseAbs().maxCoeff();
}

#endif
