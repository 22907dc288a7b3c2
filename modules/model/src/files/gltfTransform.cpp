// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/gltfTransform.h"

#include "files/fileBytes.h"

#include <algorithm>
#include <cmath>
#include <map>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
using Json = nlohmann::json;

// Of a quaternion's length from 1: what files with three digits have.
constexpr double mostDeviation = 0.01;

bool areNumbers(const Json &list, std::size_t count)
{
  return list.is_array() && list.size() == count &&
         std::all_of(list.begin(), list.end(), [](const Json &number) { return number.is_number(); });
}

bool isRotation(const Json &quaternion)
{
  double squares = 0.;
  for (const Json &number : quaternion) {
    squares += number.get<double>() * number.get<double>();
  }
  return std::abs(std::sqrt(squares) - 1.) < mostDeviation;
}
} // namespace

void requireTransform(const std::string &file, const Json &node)
{
  static const std::map<std::string, std::size_t> counts = {
      {"matrix", 16}, {"translation", 3}, {"rotation", 4}, {"scale", 3}};
  for (const auto &[name, count] : counts) {
    if (!node.is_object() || !node.contains(name)) {
      continue;
    }
    const Json &given = node[name];
    if (!areNumbers(given, count) || (name == "rotation" && !isRotation(given))) {
      refuseFile(file, "is broken: the " + name + " of a node is " + given.dump().substr(0, 80) + ", " +
                           std::to_string(count) + " numbers are needed" +
                           (name == "rotation" ? ", a quaternion of length 1" : ""));
    }
  }
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
