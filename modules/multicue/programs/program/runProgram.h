// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsRunProgram_h
#define programsRunProgram_h

#include <visp3/core/vpException.h>

#include <iostream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! \return The exit status of a program, 1 where it ends with an exception, whose text is printed.
template <typename Program> int runProgram(const Program &program)
{
  try {
    return program();
  } catch (const vpException &e) {
    std::cerr << e.getStringMessage() << std::endl;
  } catch (const std::exception &e) {
    std::cerr << e.what() << std::endl;
  }
  return 1;
}

} // namespace programs
#endif
