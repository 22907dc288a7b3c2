// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpModelSymmetriesReader.h>

#include "config/settingsText.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpJsonWatch.h>
#include <visp3/se3/vpExactNumber.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

BEGIN_VISP_NAMESPACE

namespace {
using Json = nlohmann::ordered_json;

const double millimetre = 0.001;
const int deepest = 20; // Values are written into messages by functions that call themselves.

[[noreturn]] void refuse(const std::string &place, const std::string &reason)
{
  throw vpException(vpException::badValue, place + ": " + reason);
}

Json parse(const std::string &file)
{
  const std::string place = "Symmetries' file '" + file + "'";
  try {
    return Json::parse(vpSettingsDetail::readTextFile(file),
                       vpJsonWatch(deepest, [&place](const std::string &reason) { refuse(place, reason); }));
  } catch (const Json::exception &error) {
    refuse(place, std::string("this is no JSON: ") + error.what());
  }
}

const Json &objectIn(const Json &json, const std::string &file, unsigned int object)
{
  const std::string place = "Symmetries' file '" + file + "'";
  if (!json.is_object()) {
    refuse(place, "it must be an object {...} with a member for each object's number");
  }
  std::vector<std::string> numbers;
  for (const auto &member : json.items()) {
    numbers.push_back(member.key());
  }
  if (object == 0 && numbers.size() != 1) {
    refuse(place, "the object's number is needed where there are several or none; there is: " +
                      vpSettingsDetail::listText(numbers));
  }
  const std::string number = object == 0 ? numbers.front() : std::to_string(object);
  if (!json.contains(number)) {
    refuse(place, "there is no object " + number + "; there is: " + vpSettingsDetail::listText(numbers));
  }
  return json.at(number);
}

std::vector<double> numbersOf(const Json &json, std::size_t count, const std::string &place)
{
  const bool isRight = json.is_array() && json.size() == count &&
                       std::all_of(json.begin(), json.end(), [](const Json &one) { return one.is_number(); });
  if (!isRight) {
    refuse(place, "a list of " + std::to_string(count) + " numbers is needed, not " + json.dump());
  }
  return json.get<std::vector<double>>();
}

Eigen::Vector3d vectorOf(const Json &json, const char *key, const std::string &place)
{
  if (!json.is_object() || !json.contains(key)) {
    refuse(place, std::string("an object with '") + key + "' is needed, not " + json.dump());
  }
  const std::vector<double> numbers = numbersOf(json.at(key), 3, place + ", '" + key + "'");
  return {numbers[0], numbers[1], numbers[2]};
}

vpHomogeneousMatrix matrixOf(const Json &json, const std::string &place)
{
  const std::vector<double> numbers = numbersOf(json, 16, place);
  if (!vpIsZero(numbers[12]) || !vpIsZero(numbers[13]) || !vpIsZero(numbers[14]) || vpIsOther(numbers[15], 1.)) {
    refuse(place, "the last row of the matrix must be 0 0 0 1");
  }
  vpHomogeneousMatrix oTo;
  std::copy(numbers.begin(), numbers.end(), oTo.data);
  for (unsigned int i = 0; i < 3; ++i) {
    oTo[i][3] *= millimetre;
  }
  return oTo;
}

// What is no symmetry is said with its place.
template <typename Add> void addAll(const Json &json, const char *key, const std::string &place, const Add &add)
{
  if (!json.contains(key)) {
    return;
  }
  const Json &list = json.at(key);
  const std::string name = place + ", '" + key + "'";
  if (!list.is_array()) {
    refuse(name, "a list is needed, not " + list.dump());
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string at = name + ", [" + std::to_string(i) + "]";
    try {
      add(list[i], at);
    } catch (const vpException &error) {
      const std::string text = error.what();
      text.find(at) == std::string::npos ? refuse(at, text) : throw;
    }
  }
}
} // namespace

vpModelSymmetries vpModelSymmetriesReader::read(const std::string &file, unsigned int object)
{
  const Json json = parse(file);
  const Json &info = objectIn(json, file, object);
  const std::string place =
      "Symmetries' file '" + file + "'" + (object == 0 ? std::string() : ", object " + std::to_string(object));
  if (!info.is_object()) {
    refuse(place, "an object {...} is needed, not " + info.dump());
  }
  vpModelSymmetries symmetries;
  addAll(info, "symmetries_continuous", place, [&](const Json &one, const std::string &at) {
    const bool hasOffset = one.is_object() && one.contains("offset");
    const Eigen::Vector3d offset = hasOffset ? vectorOf(one, "offset", at) : Eigen::Vector3d::Zero();
    symmetries.addAxis({vectorOf(one, "axis", at), millimetre * offset});
  });
  addAll(info, "symmetries_discrete", place,
         [&](const Json &one, const std::string &at) { symmetries.addDiscrete(matrixOf(one, at)); });
  return symmetries;
}

END_VISP_NAMESPACE
