// SPDX-License-Identifier: GPL-2.0-or-later
#include "config/settingsText.h"

#include <visp3/core/vpException.h>

#include <filesystem>
#include <fstream>
#include <iterator>
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
