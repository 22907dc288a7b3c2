// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsText_h
#define settingsText_h

#include <visp3/se3/vpCompatibility.h>

#include <clocale>
#include <optional>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
//! \return The bytes of a file. \throw vpException naming the file that is missing or cannot be read.
std::string readTextFile(const std::string &file);

//! \return The number with as many digits as it takes to tell it from its neighbours by eye, whatever the locale.
std::string numberText(double value);
//! \return Names separated by commas.
std::string listText(const std::vector<std::string> &names);

//! \return The one of some names that is the nearest to one that is none of them: the fewest letters to be put in, left
//! out, exchanged or swapped with their neighbour, capitals aside. Empty where there are no names.
std::string nearestName(const std::string &name, const std::vector<std::string> &known);

//! \return The number that the whole text is (spaces around it are allowed), whatever the locale.
std::optional<double> parseNumber(const std::string &text);
//! \return Likewise, without decimals or exponent.
std::optional<double> parseWholeNumber(const std::string &text);

//! The locale "C" while it lives: ViSP's parsers read numbers in the program's locale or, in some versions, change it.
class ClassicLocale
{
public:
  ClassicLocale() : m_before(std::setlocale(LC_ALL, nullptr)) { std::setlocale(LC_ALL, "C"); }
  ~ClassicLocale() { std::setlocale(LC_ALL, m_before.c_str()); }
  ClassicLocale(const ClassicLocale &) = delete;
  ClassicLocale &operator=(const ClassicLocale &) = delete;

private:
  std::string m_before;
};
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
