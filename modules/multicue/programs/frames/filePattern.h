// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsFilePattern_h
#define programsFilePattern_h

#include <map>
#include <string>

namespace programs {

//! A printf-style name for numbered files, such as folder/image%04d.png.
class FilePattern
{
public:
  //! \throw vpException naming the pattern, if its file name has not exactly one %d.
  explicit FilePattern(const std::string &pattern);

  //! \return The name of the file with this number.
  std::string name(int number) const;

  //! \return The files that exist, by number. \throw vpException if there is no such folder.
  std::map<int, std::string> existing() const;

private:
  std::string m_folder; //!< Never empty.
  std::string m_prefix;
  std::string m_suffix;
  std::size_t m_width;
};

} // namespace programs
#endif
