// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fileBytes_h
#define fileBytes_h

#include <visp3/se3/vpCompatibility.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/*!
  \file fileBytes.h
  Text and numbers of model files, read the same in every locale.
*/

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! \throw vpException "model 'file' reason".
[[noreturn]] void refuseFile(const std::string &file, const std::string &reason);
//! \throw vpException "model 'file', line number: reason".
[[noreturn]] void refuseLine(const std::string &file, std::size_t line, const std::string &reason);

//! \return All bytes. \throw vpException naming the file where it cannot be read, or is too large for memory.
std::string readBytes(const std::string &file);
//! Takes a byte order mark of UTF-8 off a text. \throw vpException naming the file where it has one of UTF-16.
void dropByteOrderMark(const std::string &file, std::string &text);

//! Lines of a text that lives longer, whatever their ends.
class LineWalk
{
public:
  explicit LineWalk(std::string_view text) : m_text(text) {}
  //! \return False where there are no more lines.
  bool next();
  std::string_view line() const { return m_line; }
  std::size_t number() const { return m_number; } //!< From 1.
  //! True where the text ends without the end of a line: a file that was cut off looks like that.
  bool endsInLine() const { return m_endsInLine; }

private:
  std::string_view m_text;
  std::string_view m_line;
  std::size_t m_number = 0;
  bool m_endsInLine = false;
};

//! Takes the next word off the start of a text; an empty one where there is none.
std::string_view takeWord(std::string_view &text);
//! Without blanks at both ends.
std::string_view trimmed(std::string_view text);
//! In lower case letters.
std::string lowerCase(std::string_view text);
//! \return False where the whole word is no number; infinite ones are none, but "nan" is left to be told apart.
bool parseNumber(std::string_view word, double &number);
bool parseNumber(std::string_view word, long long &number);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
