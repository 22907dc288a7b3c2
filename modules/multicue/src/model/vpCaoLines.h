// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCaoLines_h
#define vpCaoLines_h

#include "model/vpTextLines.h"

BEGIN_VISP_NAMESPACE

//! Takes counts, numbers and indices off the lines of a .cao file. What is wrong ends in a vpException with the line.
class vpCaoLines
{
public:
  //! ViSP's limit: what is larger is no model of lines and faces that somebody wrote.
  static constexpr std::size_t mostOfAKind = 100000;

  explicit vpCaoLines(const std::string &file) : m_text(vpTextLines::read(file)) {}

  bool atEnd() const { return m_next == m_text.lines.size(); }
  //! The line after the current one; there has to be one.
  const std::string &ahead() const { return m_text.lines[m_next].text; }
  //! Goes to the next line. \param what Is to stand there, for messages.
  const std::string &next(const std::string &what);
  //! \throw vpException that starts with the current line's number.
  [[noreturn]] void refuse(const std::string &reason) const;
  //! True where the current line is the file's last, holds more than one word, and is not ended.
  bool mayBeCut() const;

  //! Goes to the next line, which has to hold the number of \e what and no more numbers.
  std::size_t count(const std::string &what);
  double number(vpLineWords &words, const std::string &meant, const std::string &element) const;
  //! A number above 0.
  double radius(vpLineWords &words, const std::string &element) const;
  //! \return An index below \e count of what there is.
  std::size_t index(vpLineWords &words, std::size_t count, const std::string &meant, const std::string &element) const;
  //! How many points or lines an element has.
  std::size_t size(vpLineWords &words, const std::string &of, const std::string &element, std::size_t least) const;
  //! \throw vpException where there are more numbers on the line.
  void requireNoMore(const vpLineWords &words, const std::string &element) const;

private:
  [[noreturn]] void refuseWord(const vpLineWords &words, const std::string &meant, const std::string &element) const;

  vpTextLines m_text;
  std::size_t m_next = 0;
};

END_VISP_NAMESPACE
#endif
