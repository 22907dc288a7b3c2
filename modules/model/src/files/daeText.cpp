// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/daeText.h"

#include "files/fileBytes.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
std::string textOf(const pugi::xml_node &node)
{
  std::string text;
  for (const pugi::xml_node part : node.children()) {
    text += part.value();
  }
  return text;
}

std::string_view nextWord(std::string_view &text)
{
  const char *const blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::vector<double> numbersOf(const std::string &file, const pugi::xml_node &node)
{
  const std::string text = textOf(node);
  std::vector<double> numbers;
  std::string_view rest = text;
  for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest)) {
    numbers.push_back(0.);
    if (!parseNumber(word, numbers.back()) || !std::isfinite(numbers.back())) {
      refuseFile(file,
                 "is broken: '" + std::string(word.substr(0, 20)) + "' in <" + node.name() + "> is no finite number");
    }
  }
  return numbers;
}

std::vector<std::size_t> indicesOf(const std::string &file, const pugi::xml_node &node)
{
  const std::string text = textOf(node);
  std::vector<std::size_t> indices;
  std::string_view rest = text;
  for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest)) {
    long long index = 0;
    if (!parseNumber(word, index) || index < 0) {
      refuseFile(file,
                 "is broken: '" + std::string(word.substr(0, 20)) + "' in <" + node.name() + "> is no index or count");
    }
    indices.push_back(static_cast<std::size_t>(index));
  }
  return indices;
}

std::size_t countOf(const std::string &file, const pugi::xml_node &node, const char *attribute)
{
  long long value = 0;
  if (!parseNumber(trimmed(node.attribute(attribute).value()), value) || value < 0) {
    refuseFile(file, std::string("is broken: ") + attribute + "=\"" + node.attribute(attribute).value() + "\" of <" +
                         node.name() + "> is no count or offset");
  }
  return static_cast<std::size_t>(value);
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
