// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpTextLines.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

BEGIN_VISP_NAMESPACE

namespace {
constexpr std::uintmax_t mostBytes = 100U << 20U;
const char *const blanks = " \t\v\f";

[[noreturn]] void refuse(const std::string &reason)
{
  throw vpException(vpException::ioError, reason);
}

std::string readAll(const std::string &file)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    refuse("it is no file");
  }
  if (std::filesystem::file_size(file, error) > mostBytes) {
    refuse("it is larger than 100 MB: use a mesh (.obj, .ply) for a model of so many faces");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream) {
    refuse("it cannot be read to its end");
  }
  return text;
}

// Takes a byte order mark off, and refuses what is no text of bytes.
void checkEncoding(std::string &text)
{
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) {
    text.erase(0, 3);
  } else if (text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0) {
    refuse("line 1: its byte order mark says UTF-16; save it as plain text (UTF-8)");
  }
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos) {
    refuse("it is no text: byte " + std::to_string(zero) + " is zero");
  }
}

std::string trimmed(const std::string &line)
{
  bool quoted = false;
  std::size_t end = 0;
  while (end < line.size() && (quoted || line[end] != '#')) {
    quoted = quoted != (line[end] == '"');
    ++end;
  }
  // A quotation mark without its partner, as in a comment on inches, does not make a comment part of the line.
  end = quoted ? std::min(line.find('#'), line.size()) : end;
  const std::size_t first = line.find_first_not_of(blanks);
  if (first >= end) {
    return "";
  }
  return line.substr(first, line.find_last_not_of(blanks, end - 1) + 1 - first);
}
} // namespace

vpTextLines vpTextLines::read(const std::string &file)
{
  std::string text = readAll(file);
  checkEncoding(text);
  vpTextLines result;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
    ++result.lastNumber;
    std::string line = trimmed(text.substr(start, end - start));
    if (!line.empty()) {
      result.lines.push_back({result.lastNumber, std::move(line)});
    }
    result.endsInLine = end == text.size();
    start = end + (text.compare(end, 2, "\r\n") == 0 ? 2 : 1);
  }
  return result;
}

std::string firstBytes(const std::string &file, std::size_t count)
{
  std::string bytes(count, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(&bytes[0], static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

bool vpLineWords::numberIsNext() const
{
  return !m_rest.empty() && std::string_view("0123456789+-.,").find(m_rest.front()) != std::string_view::npos;
}

std::string_view vpLineWords::word() const
{
  return m_rest.substr(0, m_rest.find_first_of(blanks));
}

bool vpLineWords::take(double &number)
{
  std::string_view text = word();
  const std::string_view digits = text.size() > 1 && text.front() == '+' && text[1] != '-' ? text.substr(1) : text;
  const std::from_chars_result result = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  // A number that is too small to be told from 0 is 0.
  const bool tiny = result.ec == std::errc::result_out_of_range && digits.find("e-") != std::string_view::npos;
  number = tiny ? 0. : number;
  if ((result.ec != std::errc() && !tiny) || result.ptr != digits.data() + digits.size() || !std::isfinite(number)) {
    return false;
  }
  m_rest.remove_prefix(text.size());
  skipBlanks();
  return true;
}

bool vpLineWords::take(std::size_t &number)
{
  const std::string_view text = word();
  const std::from_chars_result result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() ||
      number > std::numeric_limits<std::uint32_t>::max()) {
    return false;
  }
  m_rest.remove_prefix(text.size());
  skipBlanks();
  return true;
}

bool vpLineWords::takeVersion(std::size_t &number)
{
  if (m_rest.empty() || m_rest.front() != 'V') {
    return false;
  }
  const std::string_view before = m_rest;
  m_rest.remove_prefix(1);
  const bool taken = take(number);
  m_rest = taken ? m_rest : before;
  return taken;
}

void vpLineWords::skipBlanks()
{
  m_rest.remove_prefix(std::min(m_rest.find_first_not_of(blanks), m_rest.size()));
}

END_VISP_NAMESPACE
