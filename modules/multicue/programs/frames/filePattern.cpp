// SPDX-License-Identifier: GPL-2.0-or-later
#include "frames/filePattern.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <filesystem>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {
FilePattern::FilePattern(const std::string &pattern) : m_folder("."), m_width(0)
{
  const std::filesystem::path path(pattern);
  const std::string name = path.filename().string();
  // %d, or %0 and one digit and d.
  const std::size_t begin = name.find('%');
  const std::size_t end = name.find('d', begin);
  const std::string flags = end == std::string::npos ? "?" : name.substr(begin + 1, end - begin - 1);
  const bool hasWidth = flags.size() == 2 && flags[0] == '0' && flags[1] >= '0' && flags[1] <= '9';
  if (begin == std::string::npos || name.rfind('%') != begin || !(flags.empty() || hasWidth)) {
    throw vpException(vpException::badValue, pattern + " needs one %d in the file's name, such as image%04d.png");
  }
  if (path.has_parent_path()) {
    m_folder = path.parent_path().string();
  }
  m_prefix = name.substr(0, begin);
  m_width = hasWidth ? static_cast<std::size_t>(flags[1] - '0') : 0;
  m_suffix = name.substr(end + 1);
}

std::string FilePattern::name(int number) const
{
  const std::string digits = std::to_string(number);
  const std::string zeros(m_width - std::min(m_width, digits.size()), '0');
  return (std::filesystem::path(m_folder) / (m_prefix + zeros + digits + m_suffix)).string();
}

std::map<int, std::string> FilePattern::existing() const
{
  if (!std::filesystem::is_directory(m_folder)) {
    throw vpException(vpException::ioError, "There is no folder " + m_folder);
  }
  std::map<int, std::string> files;
  for (const auto &entry : std::filesystem::directory_iterator(m_folder)) {
    const std::string file = entry.path().filename().string();
    if (file.size() <= m_prefix.size() + m_suffix.size() || file.compare(0, m_prefix.size(), m_prefix) != 0) {
      continue;
    }
    const std::string digits = file.substr(m_prefix.size(), file.size() - m_prefix.size() - m_suffix.size());
    const bool isNumber = digits.size() < 10 && digits.find_first_not_of("0123456789") == std::string::npos;
    if (isNumber && entry.path() == std::filesystem::path(name(std::stoi(digits)))) {
      files[std::stoi(digits)] = entry.path().string();
    }
  }
  return files;
}

} // namespace programs
