// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchJsonFile_h
#define benchJsonFile_h

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace bench {

/*!
  A value in a JSON file that knows where it stands: what is wrong with it is said with the file's name and the keys
  that lead to it. Every getter throws a vpException with that text where the value is of another kind.
*/
class JsonValue
{
public:
  JsonValue(const nlohmann::json &value, const std::string &place) : m_value(&value), m_place(place) {}

  //! File and keys, for messages.
  const std::string &place() const { return m_place; }
  //! \throw vpException where this is no object.
  bool has(const std::string &key) const;
  JsonValue at(const std::string &key) const;
  //! The elements of a list.
  std::vector<JsonValue> items() const;
  //! The members of an object whose keys are numbers, not negative, in their order.
  std::map<int, JsonValue> numberedMembers() const;
  //! Finite.
  double number() const;
  int integer() const;
  //! A list of as many finite numbers.
  std::vector<double> numbers(std::size_t count) const;
  [[noreturn]] void refuse(const std::string &problem) const;

private:
  const nlohmann::json *m_value;
  std::string m_place;
};

//! A JSON file that is an object.
class JsonFile
{
public:
  //! \throw vpException naming the file where it is missing, no JSON, or no object.
  explicit JsonFile(const std::filesystem::path &file);
  JsonValue root() const { return JsonValue(m_json, m_place); }

private:
  nlohmann::json m_json;
  std::string m_place;
};

} // namespace bench
#endif
