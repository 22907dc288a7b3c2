// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/daeTransform.h"

#include "files/daeText.h"
#include "files/fileBytes.h"

#include <cmath>
#include <map>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
using Numbers = std::vector<double>;

Eigen::Vector3d vectorAt(const Numbers &numbers, std::size_t first)
{
  return Eigen::Vector3d(numbers[first], numbers[first + 1], numbers[first + 2]);
}

Eigen::Affine3d matrixOf(const Numbers &numbers)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  result.matrix().topRows<3>() = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(numbers.data());
  return result;
}

Eigen::Affine3d rotationOf(const Numbers &numbers)
{
  const Eigen::Vector3d axis = vectorAt(numbers, 0);
  return axis.isZero(0.) ? Eigen::Affine3d::Identity()
                         : Eigen::Affine3d(Eigen::AngleAxisd(numbers[3] * M_PI / 180., axis.stableNormalized()));
}

// Eye, point that it looks at, and what is up for it: its z axis looks back.
Eigen::Affine3d lookAtOf(const Numbers &numbers)
{
  const Eigen::Vector3d back = (vectorAt(numbers, 0) - vectorAt(numbers, 3)).stableNormalized();
  const Eigen::Vector3d right = vectorAt(numbers, 6).cross(back).stableNormalized();
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  result.linear() << right, back.cross(right), back;
  result.translation() = vectorAt(numbers, 0);
  return result;
}

struct Kind
{
  std::size_t count; // Of its numbers.
  Eigen::Affine3d (*read)(const Numbers &numbers);
};

const std::map<std::string, Kind> &kinds()
{
  static const std::map<std::string, Kind> all = {
      {"matrix", {16, matrixOf}},
      {"rotate", {4, rotationOf}},
      {"lookat", {9, lookAtOf}},
      {"translate", {3, [](const Numbers &n) { return Eigen::Affine3d(Eigen::Translation3d(vectorAt(n, 0))); }}},
      {"scale", {3, [](const Numbers &n) { return Eigen::Affine3d(vectorAt(n, 0).asDiagonal()); }}}};
  return all;
}
} // namespace

Eigen::Affine3d transformOf(const std::string &file, const pugi::xml_node &node)
{
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  for (const pugi::xml_node &child : node.children()) {
    if (std::string(child.name()) == "skew") {
      refuseFile(file, "has a node with a <skew>, which is not read: export it with its transformations applied");
    }
    const auto kind = kinds().find(child.name());
    if (kind == kinds().end()) {
      continue;
    }
    const Numbers numbers = numbersOf(file, child);
    if (numbers.size() != kind->second.count) {
      refuseFile(file, "is broken: <" + kind->first + "> has " + std::to_string(numbers.size()) + " numbers, " +
                           std::to_string(kind->second.count) + " are needed");
    }
    result = result * kind->second.read(numbers);
  }
  return result;
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
