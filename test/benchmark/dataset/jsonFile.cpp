// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/jsonFile.h"

#include "dataset/datasetFiles.h"

#include <visp3/model/vpJsonWatch.h>
#include <visp3/se3/vpExactNumber.h>

#include <cmath>
#include <limits>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
const int deepest = 20; // Values are written into messages by functions that call themselves.
}

void JsonValue::refuse(const std::string &problem) const
{
  fail(m_place + ": " + problem);
}

bool JsonValue::has(const std::string &key) const
{
  if (!m_value->is_object()) {
    refuse(std::string("an object is needed, not a ") + m_value->type_name());
  }
  return m_value->contains(key);
}

JsonValue JsonValue::at(const std::string &key) const
{
  if (!has(key)) {
    refuse("the key '" + key + "' is missing");
  }
  return JsonValue((*m_value)[key], m_place + ", '" + key + "'");
}

std::vector<JsonValue> JsonValue::items() const
{
  if (!m_value->is_array()) {
    refuse(std::string("a list is needed, not a ") + m_value->type_name());
  }
  std::vector<JsonValue> items;
  for (std::size_t i = 0; i < m_value->size(); ++i) {
    items.emplace_back((*m_value)[i], m_place + ", [" + std::to_string(i) + "]");
  }
  return items;
}

std::map<int, JsonValue> JsonValue::numberedMembers() const
{
  if (!m_value->is_object()) {
    refuse(std::string("an object is needed, not a ") + m_value->type_name());
  }
  std::map<int, JsonValue> members;
  for (const auto &member : m_value->items()) {
    const int number = numberOf(member.key());
    if (number < 0) {
      refuse("the key '" + member.key() + "' is no number");
    }
    if (!members.emplace(number, JsonValue(member.value(), m_place + ", '" + member.key() + "'")).second) {
      refuse("the number " + std::to_string(number) + " is there twice");
    }
  }
  return members;
}

double JsonValue::number() const
{
  if (!m_value->is_number()) {
    refuse(std::string("a number is needed, not a ") + m_value->type_name());
  }
  const double number = m_value->get<double>();
  if (!std::isfinite(number)) {
    refuse("a finite number is needed");
  }
  return number;
}

int JsonValue::integer() const
{
  const double value = number();
  if (vpIsOther(value, std::floor(value)) || std::fabs(value) > std::numeric_limits<int>::max()) {
    refuse("a whole number is needed, not " + m_value->dump());
  }
  return static_cast<int>(value);
}

std::vector<double> JsonValue::numbers(std::size_t count) const
{
  std::vector<double> numbers;
  for (const JsonValue &item : items()) {
    numbers.push_back(item.number());
  }
  if (numbers.size() != count) {
    refuse(std::to_string(count) + " numbers are needed, not " + std::to_string(numbers.size()));
  }
  return numbers;
}

JsonFile::JsonFile(const std::filesystem::path &file) : m_place(inQuotes(file))
{
  const std::string text = readText(file);
  try {
    m_json = nlohmann::json::parse(
        text, vpJsonWatch(deepest, [this](const std::string &reason) { fail("The file " + m_place + ": " + reason); }));
  } catch (const nlohmann::json::exception &e) {
    fail("The file " + m_place + " is no JSON: " + e.what());
  }
  if (!m_json.is_object()) {
    fail("The file " + m_place + " has to be a JSON object");
  }
}

} // namespace bench
