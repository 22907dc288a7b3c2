// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsFilePattern_h
#define programsFilePattern_h

#include <map>
#include <string>

namespace programs {

//! A name for numbered files as printf() writes it, such as folder/image%04d.png: one %d, and %% for a percent sign.
class FilePattern
{
public:
  //! \throw vpException naming the pattern, if it has not exactly one %d.
  explicit FilePattern(const std::string &pattern);

  //! \return The name of the file with this number.
  std::string name(int number) const;

  //! \return The files that exist, by number. \throw vpException if there is no such folder.
  std::map<int, std::string> existing() const;

  /*!
    The frames of a recording, the same ones for every program that reads it.
    \param first Number of the first frame, -1 for the first that there is.
    \param last Number that no frame is above, -1 for the last that there is.
    \param step From the number of one frame to that of the next, > 0.
    \throw vpException naming the file that is missing, if one is: a gap is no end.
  */
  std::map<int, std::string> frames(int first, int last, int step) const;

private:
  [[noreturn]] void refuse() const;
  void readConversion(const std::string &flags);
  int numberIn(const std::string &digits) const;

  std::string m_pattern;
  std::string m_before; //!< What stands before the number, with its folder.
  std::string m_after;
  std::size_t m_width = 0;
  char m_fill = ' '; //!< What a number is filled up with to its width.
};

} // namespace programs
#endif
