// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpCaoParameters.h"

#include "model/vpTextLines.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

BEGIN_VISP_NAMESPACE

namespace {
[[noreturn]] void refuse(const std::string &reason)
{
  throw vpException(vpException::badValue, reason);
}

std::string_view trimmed(std::string_view text)
{
  const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
  text.remove_prefix(first);
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

// Takes "name=value" or "name="quoted value"" off the text.
std::string takeValue(std::string_view &text, bool mayBeQuoted)
{
  if (mayBeQuoted && text.size() > 2 && text.front() == '"' && text.find('"', 1) != std::string_view::npos) {
    const std::size_t end = text.find('"', 1);
    const std::string value(text.substr(1, end - 1));
    text.remove_prefix(end + 1);
    return value;
  }
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  const std::string value(text.substr(0, end));
  text.remove_prefix(end);
  return value;
}

double numberOf(const std::string &parameter, const std::string &value)
{
  vpLineWords words(value);
  double number = 0.;
  if (!words.take(number) || number < 0.) {
    refuse(parameter + " is '" + value + "', it must be a number of at least 0");
  }
  return number;
}

bool flagOf(const std::string &parameter, std::string value)
{
  std::transform(value.begin(), value.end(), value.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (value != "true" && value != "false" && value != "1" && value != "0") {
    refuse(parameter + " is '" + value + "', it must be true or false");
  }
  return value == "true" || value == "1";
}

void set(const std::string &parameter, const std::string &value, vpCaoShape &shape)
{
  if (parameter == "name") {
    shape.name = value;
  } else if (parameter == "useLod") {
    shape.useLod = flagOf(parameter, value);
  } else if (parameter == "minLineLengthThreshold") {
    shape.minLineLength = numberOf(parameter, value);
  } else {
    shape.minPolygonArea = numberOf(parameter, value);
  }
}

// Three numbers between brackets, separated by semicolons; \e degrees in radians where a unit says so.
vpColVector takeTriple(std::string_view &text, bool areAngles)
{
  const std::size_t end = text.find(']');
  const std::string list(text.substr(0, end));
  vpColVector result(3);
  std::size_t start = 0;
  for (unsigned int i = 0; i < 3; ++i) {
    const std::size_t stop = list.find(';', start);
    if (end == std::string_view::npos || (stop == std::string::npos) != (i == 2)) {
      refuse("'[" + list + "' is to be three numbers between brackets, separated by semicolons");
    }
    std::string_view value = trimmed(std::string_view(list).substr(start, stop - start));
    const std::string_view unit = value.size() > 3 ? value.substr(value.size() - 3) : std::string_view();
    const bool hasUnit = areAngles && (unit == "deg" || unit == "rad");
    value = trimmed(hasUnit ? value.substr(0, value.size() - 3) : value);
    vpLineWords words(value);
    if (!words.take(result[i]) || !words.rest().empty()) {
      refuse("'" + std::string(value) + "' is no number of load()" +
             (value.find(',') != std::string_view::npos ? ": a decimal comma? Write numbers with a point (0.5)" : ""));
    }
    result[i] = hasUnit && unit == "deg" ? vpMath::rad(result[i]) : result[i];
    start = stop + 1;
  }
  text.remove_prefix(end + 1);
  return result;
}

bool takeWord(std::string_view &text, std::string_view word)
{
  text = trimmed(text);
  if (text.substr(0, word.size()) != word) {
    return false;
  }
  text.remove_prefix(word.size());
  return true;
}
} // namespace

void readCaoParameters(std::string_view text, vpCaoShape &shape)
{
  static const std::array<std::string, 4> names = {
      {"name", "useLod", "minLineLengthThreshold", "minPolygonAreaThreshold"}};
  for (bool any = true; any;) {
    any = false;
    for (const std::string &name : names) {
      if (takeWord(text, name + "=")) {
        set(name, takeValue(text, name == "name"), shape);
        any = true;
      }
    }
  }
}

vpCaoLoad vpCaoLoad::parse(const std::string &line, const std::string &parent)
{
  const std::string form = "load(\"part.cao\", t=[x; y; z], tu=[x deg; y deg; z deg])";
  std::string_view text = line;
  if (!takeWord(text, "load") || !takeWord(text, "(") || !takeWord(text, "\"") ||
      text.find('"') == std::string_view::npos) {
    refuse("'" + line.substr(0, 40) + "' is to be " + form);
  }
  const std::filesystem::path name(std::string(text.substr(0, text.find('"'))));
  text.remove_prefix(text.find('"') + 1);
  vpTranslationVector translation;
  vpThetaUVector rotation;
  while (takeWord(text, ",")) {
    if (takeWord(text, "t=[")) {
      translation.buildFrom(takeTriple(text, false));
    } else if (takeWord(text, "tu=[")) {
      rotation.buildFrom(takeTriple(text, true));
    } else {
      refuse("'" + std::string(text.substr(0, 20)) + "' is not known in " + form);
    }
  }
  if (!takeWord(text, ")")) {
    refuse("a closing parenthesis is missing in " + form);
  }
  vpCaoLoad load;
  load.file = (std::filesystem::path(parent).parent_path() / name).string();
  load.pose.buildFrom(translation, rotation);
  std::error_code error;
  if (!std::filesystem::is_regular_file(load.file, error)) {
    refuse("the part '" + load.file + "' does not exist or is no file");
  }
  return load;
}

END_VISP_NAMESPACE
