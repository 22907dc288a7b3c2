// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTextLines_h
#define vpTextLines_h

#include <visp3/se3/vpCompatibility.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

BEGIN_VISP_NAMESPACE

//! A line of a text file that has more than a comment in it.
struct vpTextLine
{
  std::size_t number = 0; //!< In the file, from 1.
  std::string text;       //!< Without comment and without blanks at its ends.
};

//! The lines of a text file with anything in them, whatever its line ends.
struct vpTextLines
{
  std::vector<vpTextLine> lines;
  std::size_t lastNumber = 0; //!< Of the last line in the file.
  bool endsInLine = false;    //!< The last character is not the end of a line: a file that was cut off looks like that.

  /*!
    A comment goes from # outside quotation marks to the end of the line. A byte order mark of UTF-8 is passed over.
    \throw vpException without the file's name where it cannot be read, is no text, or not one of bytes.
  */
  static vpTextLines read(const std::string &file);
};

//! \return The first bytes of a file, or as many as there are; none where it cannot be read.
std::string firstBytes(const std::string &file, std::size_t count);

//! Takes words and numbers off the start of a line. Numbers are read as in the locale "C", whatever the program's is.
class vpLineWords
{
public:
  explicit vpLineWords(std::string_view text) : m_rest(text) { skipBlanks(); }

  std::string_view rest() const { return m_rest; }
  //! True where what is left starts like a number.
  bool numberIsNext() const;
  //! The next word, up to a blank.
  std::string_view word() const;
  //! \return False, with nothing taken, where the next word is no finite number.
  bool take(double &number);
  //! \return False, with nothing taken, where the next word is no whole number in [0, 4294967295].
  bool take(std::size_t &number);

  //! Takes V1 and the like. \return False, with nothing taken, where the next word is none.
  bool takeVersion(std::size_t &number);

private:
  void skipBlanks();

  std::string_view m_rest;
};

END_VISP_NAMESPACE
#endif
