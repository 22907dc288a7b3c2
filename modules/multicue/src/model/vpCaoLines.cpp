// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpCaoLines.h"

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

namespace {
// Cutting a face into triangles takes time that grows with the square of its corners, or worse.
constexpr std::size_t mostCorners = 1000;
} // namespace

void vpCaoLines::refuse(const std::string &reason) const
{
  const std::size_t number = m_next == 0 ? 1 : m_text.lines[m_next - 1].number;
  throw vpException(vpException::badValue, "line " + std::to_string(number) + ": " + reason);
}

const std::string &vpCaoLines::next(const std::string &what)
{
  if (atEnd()) {
    throw vpException(vpException::badValue, "line " + std::to_string(m_text.lastNumber) + ": the file ends where " +
                                                 what +
                                                 " is to follow: it was cut off, or a count before is too large");
  }
  return m_text.lines[m_next++].text;
}

bool vpCaoLines::mayBeCut() const
{
  const vpTextLine &line = m_text.lines[m_next - 1];
  return m_text.endsInLine && line.number == m_text.lastNumber && line.text.find_first_of(" \t") != std::string::npos;
}

std::size_t vpCaoLines::count(const std::string &what)
{
  const std::string &line = next("the number of " + what);
  vpLineWords words(line);
  std::size_t count = 0;
  if (!words.take(count)) {
    refuse("'" + std::string(words.word()) + "' is no count: the number of " + what + " is to stand here");
  }
  if (words.numberIsNext()) {
    refuse("the number of " + what + " is to stand here alone, but more numbers follow it ('" + line.substr(0, 40) +
           "'): is the count of the section before too small?");
  }
  if (count > mostOfAKind) {
    refuse(std::to_string(count) + " are too many " + what + " for a .cao file, at most " +
           std::to_string(mostOfAKind) + " are taken: use a mesh (.obj, .ply) for a model of so many");
  }
  if (count > m_text.lines.size() - m_next) {
    refuse("the count says " + std::to_string(count) + " " + what + ", but the file has only " +
           std::to_string(m_text.lines.size() - m_next) + " more lines");
  }
  return count;
}

void vpCaoLines::refuseWord(const vpLineWords &words, const std::string &meant, const std::string &element) const
{
  if (words.rest().empty()) {
    refuse("the line of " + element + " ends before " + meant +
           ": it has too few numbers, or the count of its section is too large");
  }
  const std::string word(words.word());
  const bool comma = word.find(',') != std::string::npos;
  refuse("'" + word + "' is no number for " + meant + " of " + element +
         (comma ? ": a decimal comma? Write numbers with a point (0.5)" : ""));
}

double vpCaoLines::number(vpLineWords &words, const std::string &meant, const std::string &element) const
{
  double number = 0.;
  if (!words.take(number)) {
    refuseWord(words, meant, element);
  }
  return number;
}

double vpCaoLines::radius(vpLineWords &words, const std::string &element) const
{
  const double radius = number(words, "the radius", element);
  if (!(radius > 0.)) {
    refuse("the radius of " + element + " is not above 0");
  }
  return radius;
}

std::size_t vpCaoLines::index(vpLineWords &words, std::size_t count, const std::string &meant,
                              const std::string &element) const
{
  std::size_t index = 0;
  if (!words.take(index)) {
    refuseWord(words, "an index of a " + meant, element);
  }
  if (index >= count) {
    refuse("index " + std::to_string(index) + " of " + element + " is out of range: there are " +
           std::to_string(count) + " " + meant + "s, the first is 0");
  }
  return index;
}

std::size_t vpCaoLines::size(vpLineWords &words, const std::string &of, const std::string &element,
                             std::size_t least) const
{
  std::size_t size = 0;
  if (!words.take(size)) {
    refuseWord(words, "the number of its " + of, element);
  }
  if (size < least || size > mostCorners) {
    refuse(element + " is said to have " + std::to_string(size) + " " + of + ", but it needs " + std::to_string(least) +
           " to " + std::to_string(mostCorners) +
           ": delete the line and count one less in its section, or is an earlier count wrong?");
  }
  return size;
}

void vpCaoLines::requireNoMore(const vpLineWords &words, const std::string &element) const
{
  if (words.numberIsNext()) {
    refuse("'" + std::string(words.word()) + "' is one number too many for " + element +
           ": is its count, or the one of its section, right?");
  }
}

END_VISP_NAMESPACE
