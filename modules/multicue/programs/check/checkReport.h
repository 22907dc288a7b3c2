// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsCheckReport_h
#define programsCheckReport_h

#include <cstdio>
#include <string>
#include <vector>

namespace programs {

//! What a check of a set-up found.
struct CheckReport
{
  std::vector<std::string> lines;  //!< What there is, a line for each topic.
  std::vector<std::string> faults; //!< What is wrong, a line for each, with what to do.

  //! \param topic One word. \param text A line.
  void say(const std::string &topic, const std::string &text)
  {
    const std::size_t width = 10;
    lines.push_back(topic + std::string(topic.size() < width ? width - topic.size() : 1, ' ') + text);
  }
  void blame(const std::string &topic, const std::string &text) { faults.push_back(topic + ": " + oneLine(text)); }

private:
  static std::string oneLine(std::string text)
  {
    for (char &letter : text) {
      letter = letter == '\n' ? ' ' : letter;
    }
    return text;
  }
};

//! \param number How it is printed, "%.2f" for instance, with a few words around it.
inline std::string printed(const char *number, double value)
{
  char text[128];
  std::snprintf(text, sizeof text, number, value);
  return text;
}

//! \return A length with a unit that suits it.
inline std::string lengthText(double metres)
{
  return metres < 0.01 ? printed("%.2f mm", 1000. * metres)
         : metres < 1. ? printed("%.1f cm", 100. * metres)
                       : printed("%.2f m", metres);
}

} // namespace programs
#endif
