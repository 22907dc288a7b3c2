// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/fileBytes.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
namespace {
// Text of three million triangles has a fourth of that.
constexpr std::uintmax_t mostBytes = std::uintmax_t(1) << 29U;
const char *const blanks = " \t\v\f";

template <typename Number> bool parseWhole(std::string_view word, Number &number)
{
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), number);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}
} // namespace

void refuseFile(const std::string &file, const std::string &reason)
{
  throw vpException(vpException::ioError, "model '" + file + "' " + reason);
}

void refuseLine(const std::string &file, std::size_t line, const std::string &reason)
{
  throw vpException(vpException::ioError, "model '" + file + "', line " + std::to_string(line) + ": " + reason);
}

std::string readBytes(const std::string &file)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > mostBytes) {
    refuseFile(file, "is larger than 512 MB: reduce its triangles, a tracker needs thousands of them, not millions");
  }
  std::string bytes(error ? 0 : static_cast<std::size_t>(size), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(&bytes[0], static_cast<std::streamsize>(bytes.size()));
  if (error || static_cast<std::size_t>(stream.gcount()) != bytes.size()) {
    refuseFile(file, "cannot be read to its end");
  }
  return bytes;
}

void dropByteOrderMark(const std::string &file, std::string &text)
{
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) {
    text.erase(0, 3);
  } else if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0) {
    refuseFile(file, "is UTF-16 by its byte order mark: save it as plain text (UTF-8)");
  }
}

bool LineWalk::next()
{
  if (m_text.empty()) {
    return false;
  }
  const std::size_t end = std::min(m_text.find_first_of("\r\n"), m_text.size());
  m_line = m_text.substr(0, end);
  m_endsInLine = end == m_text.size();
  m_text.remove_prefix(std::min(end + (m_text.substr(end, 2) == "\r\n" ? 2 : 1), m_text.size()));
  ++m_number;
  return true;
}

std::string_view takeWord(std::string_view &text)
{
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::string_view trimmed(std::string_view text)
{
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string lowerCase(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

bool parseNumber(std::string_view word, double &number)
{
  if (parseWhole(word, number)) {
    return !std::isinf(number);
  }
  // A number that is too small to be told from 0 is 0, as for every other reader.
  const std::size_t exponent = lowerCase(word).find("e-");
  const bool tiny = exponent != std::string::npos && parseWhole(word.substr(0, exponent), number) &&
                    exponent + 2 < word.size() &&
                    word.find_first_not_of("0123456789", exponent + 2) == std::string_view::npos;
  number = tiny ? 0. : number;
  return tiny;
}

bool parseNumber(std::string_view word, long long &number)
{
  return parseWhole(word, number);
}
} // namespace vpMeshDetail
END_VISP_NAMESPACE
