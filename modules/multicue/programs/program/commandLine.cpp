// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/commandLine.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

namespace {
template <typename Number> Number toNumber(const std::string &name, const std::string &text)
{
  std::istringstream stream(text);
  Number value{};
  if (!(stream >> value) || !(stream >> std::ws).eof()) {
    throw vpException(vpException::badValue, "%s: '%s' is not a number of the kind that is needed", name.c_str(),
                      text.c_str());
  }
  return value;
}
} // namespace

std::vector<std::string> splitList(const std::string &text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    if (!part.empty()) {
      parts.push_back(part);
    }
  }
  return parts;
}

CommandLine::CommandLine(const std::string &purpose) : m_purpose(purpose)
{
}

void CommandLine::add(const std::string &name, const std::string &help, std::string &value)
{
  m_options.push_back({name, help, true, [&value](const std::string &text) { value = text; }});
}

void CommandLine::add(const std::string &name, const std::string &help, std::vector<std::string> &list)
{
  m_options.push_back({name, help, true, [&list](const std::string &text) { list = splitList(text); }});
}

void CommandLine::add(const std::string &name, const std::string &help, std::vector<int> &list)
{
  m_options.push_back({name, help, true, [name, &list](const std::string &text) {
                         list.clear();
                         for (const std::string &part : splitList(text)) {
                           list.push_back(toNumber<int>(name, part));
                         }
                       }});
}

void CommandLine::add(const std::string &name, const std::string &help, int &value, int least)
{
  m_options.push_back({name, help, true, [name, &value, least](const std::string &text) {
                         const int number = toNumber<int>(name, text);
                         if (number < least) {
                           throw vpException(vpException::badValue, "%s: %d is less than %d", name.c_str(), number,
                                             least);
                         }
                         value = number;
                       }});
}

void CommandLine::add(const std::string &name, const std::string &help, double &value)
{
  m_options.push_back(
      {name, help, true, [name, &value](const std::string &text) { value = toNumber<double>(name, text); }});
}

void CommandLine::add(const std::string &name, const std::string &help, bool &flag)
{
  m_options.push_back({name, help, false, [&flag](const std::string &) { flag = true; }});
}

void CommandLine::addSetter(const std::string &name, const std::string &help,
                            const std::function<void(const std::string &)> &set)
{
  m_options.push_back({name, help, true, set});
}

void CommandLine::printHelp() const
{
  std::cout << m_purpose << "\n\nOptions:\n";
  for (const Option &option : m_options) {
    const std::string left = "  " + option.name + (option.hasValue ? " VALUE" : "");
    std::cout << left << std::string(left.size() < 22 ? 22 - left.size() : 1, ' ') << option.help << "\n";
  }
  std::cout << "  --help              print this\n  --version           print the version\n" << m_epilogue;
}

bool CommandLine::read(int argc, const char *const argv[]) const
{
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--help" || name == "-h") {
      printHelp();
      return false;
    }
    if (name == "--version") {
      const std::string program = argv[0];
      std::cout << program.substr(program.find_last_of('/') + 1) << " " << MULTICUE_VERSION << std::endl;
      return false;
    }
    const auto option =
        std::find_if(m_options.begin(), m_options.end(), [&name](const Option &known) { return known.name == name; });
    if (option == m_options.end()) {
      throw vpException(vpException::badValue, "Option '%s' is not known; --help lists all", name.c_str());
    }
    if (option->hasValue && i + 1 == argc) {
      throw vpException(vpException::badValue, "Option '%s' lacks its value", name.c_str());
    }
    option->set(option->hasValue ? argv[++i] : "");
  }
  return true;
}

} // namespace programs
