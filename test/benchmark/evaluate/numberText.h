// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchNumberText_h
#define benchNumberText_h

#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

namespace bench {

//! \return The number with so many digits after the point; empty where it has no value.
inline std::string number(double value, int digits)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return std::isfinite(value) ? text.str() : "";
}

//! \return A share in [0, 1] as percent; empty where it has no value.
inline std::string percent(double share)
{
  return number(100. * share, 1);
}

//! A field of a CSV file: one with a comma in it would be two.
inline std::string field(const std::string &text)
{
  return text.find_first_of(",\"") == std::string::npos ? text : "\"" + text + "\"";
}

} // namespace bench
#endif
