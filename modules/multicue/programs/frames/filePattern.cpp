// SPDX-License-Identifier: GPL-2.0-or-later
#include "frames/filePattern.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <filesystem>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace fs = std::filesystem;

namespace programs {
namespace {
// Of a number: more are no frame's.
constexpr std::size_t mostDigits = 9;
} // namespace

FilePattern::FilePattern(const std::string &pattern) : m_pattern(pattern)
{
  bool found = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    std::string &text = found ? m_after : m_before;
    if (pattern[i] != '%') {
      text += pattern[i];
      continue;
    }
    const std::size_t end = pattern.find_first_not_of("0123456789", i + 1);
    if (end == i + 1 && pattern[end] == '%') {
      text += '%';
    } else if (end != std::string::npos && pattern[end] == 'd' && !found) {
      found = true;
      readConversion(pattern.substr(i + 1, end - i - 1));
    } else {
      refuse();
    }
    i = end;
  }
  if (!found) {
    refuse();
  }
}

// What stands between % and d: a width, filled up with zeros where it starts with one.
void FilePattern::readConversion(const std::string &flags)
{
  if (flags.size() > 3) {
    refuse();
  }
  m_fill = !flags.empty() && flags[0] == '0' ? '0' : ' ';
  m_width = flags.empty() ? 0 : static_cast<std::size_t>(std::stoi(flags));
}

void FilePattern::refuse() const
{
  throw vpException(vpException::badValue, "'" + m_pattern +
                                               "' is no pattern of numbered files: it needs one %d where their number "
                                               "is, such as image%04d.png");
}

std::string FilePattern::name(int number) const
{
  const std::string digits = std::to_string(number);
  return m_before + std::string(m_width - std::min(m_width, digits.size()), m_fill) + digits + m_after;
}

// -1 where the text is no number as name() writes it.
int FilePattern::numberIn(const std::string &digits) const
{
  const std::size_t first = std::min(digits.find_first_not_of(m_fill == ' ' ? " " : ""), digits.size());
  const std::string number = digits.substr(first);
  if (number.empty() || number.size() > std::max(mostDigits, m_width) ||
      number.find_first_not_of("0123456789") != std::string::npos) {
    return -1;
  }
  const std::size_t significant = std::min(number.find_first_not_of('0'), number.size() - 1);
  return number.size() - significant > mostDigits ? -1 : std::stoi(number);
}

std::map<int, std::string> FilePattern::existing() const
{
  // The number may stand in the name of a folder: what follows it there is not part of the name that is looked for.
  const std::string suffix = m_after.substr(0, m_after.find('/'));
  const std::size_t slash = m_before.find_last_of('/');
  const fs::path folder = slash == std::string::npos ? "." : m_before.substr(0, slash + 1);
  const std::string prefix = m_before.substr(slash + 1); // The whole where there is no slash.
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw vpException(vpException::ioError, "There is no folder '" + folder.string() + "'");
  }
  std::map<int, std::string> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string file = entry->path().filename().string();
    if (file.size() <= prefix.size() + suffix.size() || file.compare(0, prefix.size(), prefix) != 0) {
      continue;
    }
    const int number = numberIn(file.substr(prefix.size(), file.size() - prefix.size() - suffix.size()));
    std::error_code ignored;
    if (number >= 0 && name(number).substr(slash + 1, file.size()) == file &&
        fs::is_regular_file(name(number), ignored)) {
      files[number] = name(number);
    }
  }
  if (error) {
    throw vpException(vpException::ioError, "The folder '" + folder.string() + "' cannot be read: " + error.message());
  }
  return files;
}

std::map<int, std::string> FilePattern::frames(int first, int last, int step) const
{
  const std::map<int, std::string> files = existing();
  if (files.empty()) {
    throw vpException(vpException::ioError, "There is no file '" + m_pattern + "': '" + name(std::max(first, 0)) +
                                                "' is missing, and all others are");
  }
  const int start = first < 0 ? files.begin()->first : first;
  const int end = last < 0 ? std::max(files.rbegin()->first, start) : last;
  std::map<int, std::string> frames;
  for (long number = start; number <= end; number += step) {
    const auto file = files.find(static_cast<int>(number));
    if (file == files.end()) {
      const auto later = files.upper_bound(static_cast<int>(number));
      throw vpException(vpException::ioError,
                        "The image '" + name(static_cast<int>(number)) + "' is missing" +
                            (later == files.end() ? ""
                                                  : ", but '" + later->second +
                                                        "' is there: number the images without gaps, or say the first "
                                                        "one, the last one and the step between them"));
    }
    frames.insert(*file);
  }
  return frames;
}

} // namespace programs
