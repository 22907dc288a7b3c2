// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/vispJsonCarrier.h"

#include <visp3/core/vpException.h>

#include <algorithm>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
using Json = VispJsonCarrier::Json;

// "/features/0/movingEdge" as "features[0].movingEdge".
std::string readable(const std::string &pointer)
{
  std::string text;
  std::size_t start = 1;
  while (start <= pointer.size()) {
    const std::size_t end = std::min(pointer.find('/', start), pointer.size());
    const std::string part = pointer.substr(start, end - start);
    const bool isNumber = !part.empty() && part.find_first_not_of("0123456789") == std::string::npos;
    text += isNumber ? '[' + part + ']' : (text.empty() ? "" : ".") + part;
    start = end + 1;
  }
  return text;
}

// The entry of the longest pointer that is the given one or leads to it; null where there is none.
template <typename Value> const Value *findAbove(const std::map<std::string, Value> &entries, std::string pointer)
{
  while (!pointer.empty()) {
    const auto found = entries.find(pointer);
    if (found != entries.end()) {
      return &found->second;
    }
    pointer.resize(pointer.rfind('/'));
  }
  return nullptr;
}

} // namespace

std::string VispJsonCarrier::escaped(const std::string &key)
{
  std::string text;
  for (const char letter : key) {
    text += letter == '~' ? "~0" : letter == '/' ? "~1" : std::string(1, letter);
  }
  return text;
}
const Json &VispJsonCarrier::at(const std::string &theirs) const
{
  static const Json none = Json::object();
  return has(theirs) ? m_file.at(Json::json_pointer(theirs)) : none;
}

const Json &VispJsonCarrier::objectAt(const std::string &theirs) const
{
  const Json &json = at(theirs);
  if (!json.is_object()) {
    throw vpException(vpException::badValue, "'" + readable(theirs) + "' is no object {...}");
  }
  return json;
}

void VispJsonCarrier::set(const std::string &ours, const Json &value)
{
  const std::size_t dot = ours.find('.');
  (dot == std::string::npos ? m_known[ours] : m_known[ours.substr(0, dot)][ours.substr(dot + 1)]) = value;
}

void VispJsonCarrier::note(const std::string &theirs, const std::string &ours, const std::string &difference)
{
  m_taken[theirs] = {ours, difference};
}

void VispJsonCarrier::takeAs(const std::string &theirs, const std::string &ours, const Json &value,
                             const std::string &difference)
{
  if (has(theirs)) {
    set(ours, value);
    note(theirs, ours, difference);
  }
}

void VispJsonCarrier::take(const std::string &theirs, const std::string &ours, const std::string &difference)
{
  takeAs(theirs, ours, at(theirs), difference);
}

bool VispJsonCarrier::isSplit(const std::string &list) const
{
  const std::string first = list + "/0";
  return m_taken.count(first) > 0 || m_reasons.count(first) > 0;
}

void VispJsonCarrier::report(const Json &json, const std::string &pointer, vpConfigReport &report_) const
{
  if (const Taken *taken = findAbove(m_taken, pointer)) {
    report_.taken.push_back({readable(pointer), taken->ours, taken->difference});
  } else if (json.is_object() && !json.empty()) {
    for (const auto &[key, value] : json.items()) {
      report(value, pointer + '/' + escaped(key), report_);
    }
  } else if (json.is_array() && !json.empty() && (json.front().is_structured() || isSplit(pointer))) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      report(json[i], pointer + '/' + std::to_string(i), report_);
    }
  } else if (!pointer.empty()) {
    const std::string *reason = findAbove(m_reasons, pointer);
    report_.left.push_back({readable(pointer), "", reason != nullptr ? *reason : "there is nothing like it here"});
  }
}

VispJson VispJsonCarrier::result(vpConfigReport::Format format) const
{
  VispJson result;
  result.known = m_known;
  result.report.format = format;
  report(m_file, "", result.report);
  return result;
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
