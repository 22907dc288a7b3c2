// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsText.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
namespace {
template <typename Number> std::optional<double> parse(const std::string &text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Number number;
  if (!(stream >> number)) {
    return std::nullopt;
  }
  stream >> std::ws;
  return stream.eof() ? std::optional<double>(static_cast<double>(number)) : std::nullopt;
}
} // namespace

std::string readTextFile(const std::string &file)
{
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    throw vpException(vpException::ioError, "Configuration file '" + file + "' does not exist");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, error)) {
    throw vpException(vpException::ioError, "Configuration file '" + file + "' cannot be read");
  }
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (stream.bad()) {
    throw vpException(vpException::ioError, "Configuration file '" + file + "' cannot be read to its end");
  }
  return text;
}

std::string numberText(double value)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(10);
  stream << value;
  return stream.str();
}

std::string listText(const std::vector<std::string> &names)
{
  std::string text;
  for (const std::string &name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

namespace {
std::string lowered(const std::string &name)
{
  std::string text = name;
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

// Damerau's distance with neighbours swapped at most once (optimal string alignment).
std::size_t editDistance(const std::string &a, const std::string &b)
{
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t exchanged = a[i - 1] == b[j - 1] ? 0 : 1;
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, cost[i - 1][j - 1] + exchanged});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}
} // namespace

std::string nearestName(const std::string &name, const std::vector<std::string> &known)
{
  // Names are short; what a broken file has in their place may be of any length.
  constexpr std::size_t longest = 60;
  const std::string given = lowered(name.substr(0, longest));
  std::string nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string &one : known) {
    const std::size_t distance = editDistance(given, lowered(one));
    if (distance < least) {
      least = distance;
      nearest = one;
    }
  }
  return nearest;
}

std::optional<double> parseNumber(const std::string &text)
{
  return parse<double>(text);
}

std::optional<double> parseWholeNumber(const std::string &text)
{
  return parse<long long>(text);
}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
