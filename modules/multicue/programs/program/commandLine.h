// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsCommandLine_h
#define programsCommandLine_h

#include <functional>
#include <string>
#include <vector>

namespace programs {

//! Options of the form `--name value`, and `--name` alone for switches.
class CommandLine
{
public:
  //! \param purpose First lines of the help.
  explicit CommandLine(const std::string &purpose);

  void add(const std::string &name, const std::string &help, std::string &value);
  void add(const std::string &name, const std::string &help, std::vector<std::string> &list); //!< Separated by commas.
  void add(const std::string &name, const std::string &help, std::vector<int> &list);         //!< Separated by commas.
  void add(const std::string &name, const std::string &help, int &value, int least);
  void add(const std::string &name, const std::string &help, double &value);
  void add(const std::string &name, const std::string &help, bool &flag); //!< A switch without a value.
  //! \param set Takes the value, or throws.
  void addSetter(const std::string &name, const std::string &help, const std::function<void(const std::string &)> &set);

  //! Text that --help prints after the options. \param text Lines, each with its end.
  void setEpilogue(const std::string &text) { m_epilogue = text; }

  /*!
    \return False where --help or --version was asked for and printed.
    \throw vpException naming the option that is unknown, lacks its value, or has one that is no number or too small.
  */
  bool read(int argc, const char *const argv[]) const;

private:
  struct Option
  {
    std::string name;
    std::string help;
    bool hasValue = true;
    std::function<void(const std::string &)> set;
  };

  void printHelp() const;

  std::string m_purpose;
  std::string m_epilogue;
  std::vector<Option> m_options;
};

//! Parts of \e text between commas, the empty ones left out.
std::vector<std::string> splitList(const std::string &text);

} // namespace programs
#endif
