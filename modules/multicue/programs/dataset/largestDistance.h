// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsLargestDistance_h
#define programsLargestDistance_h

#include <Eigen/Core>

#include <vector>

namespace programs {

//! Largest distance of two points.
double largestDistance(const std::vector<Eigen::Vector3d> &points);

} // namespace programs
#endif
