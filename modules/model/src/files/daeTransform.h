// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef daeTransform_h
#define daeTransform_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Geometry>
#include <pugixml.hpp>

#include <string>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
/*!
  \param node A <node> of COLLADA.
  \return The product of its transformations, in the order in which they stand.
  \throw vpException naming the file, where one has another count of numbers than it needs, or is not known.
*/
Eigen::Affine3d transformOf(const std::string &file, const pugi::xml_node &node);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
