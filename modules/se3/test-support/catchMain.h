// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef catchMain_h
#define catchMain_h

/*!
  \file catchMain.h
  Catch2 and main() for a test that consists of one source file: include this header and write test cases.

  The Catch2 that ViSP bundles comes first: inside ViSP's tree the tests are linked with that one, even where the
  system has another. Version 2 is a single header that has to hold the runner; version 3 is linked as a library.
  With MULTICUE_CATCH_MAIN_IS_LINKED, runner and main() are linked too: they take longer to compile than most tests.
*/

#ifndef MULTICUE_CATCH_MAIN_IS_LINKED
#define CATCH_CONFIG_RUNNER
#endif

#if __has_include(<catch_amalgamated.hpp>)
#include <catch_amalgamated.hpp>
#elif __has_include(<catch.hpp>)
#include <catch.hpp>
#elif __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#elif __has_include(<catch2/catch.hpp>)
#include <catch2/catch.hpp>
#else
#error "Catch2 was not found: install it (Debian: catch2), or configure with -DBUILD_TESTING=OFF"
#endif

#include <visp3/core/vpConfig.h>

#include <functional>
#include <ostream>

#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
BEGIN_VISP_NAMESPACE
END_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

#if CATCH_VERSION_MAJOR >= 3
using Catch::Approx;
using Catch::Matchers::ContainsSubstring; // not the whole namespace: it has an Approx of its own
#else
// Version 3 calls the matcher for a part of a message so; its own Contains looks into ranges.
inline Catch::Matchers::StdString::ContainsMatcher ContainsSubstring(const std::string &text)
{
  return Catch::Matchers::Contains(text);
}
#endif

#ifndef MULTICUE_CATCH_MAIN_IS_LINKED
// ViSP starts its tests with -c, -d and --no-display; Catch2 knows the first two with another meaning.
int main(int argc, char *argv[])
{
  std::vector<const char *> kept;
  for (int i = 0; i < argc; i++) {
    const std::string argument = argv[i];
    if (i == 0 || (argument != "-c" && argument != "-d" && argument != "--no-display")) {
      kept.push_back(argv[i]);
    }
  }
  return Catch::Session().run(static_cast<int>(kept.size()), kept.data());
}

#endif

// In the namespace of what it is compared with.
namespace exactNumber {
//! A number that another one has to be to the last bit: what was handed on, or what arithmetic gives without rounding.
struct Exactly
{
  double value;
};
inline bool operator==(double a, const Exactly &b)
{
  return std::equal_to<double>()(a, b.value);
}
inline bool operator!=(double a, const Exactly &b)
{
  return !(a == b);
}
inline std::ostream &operator<<(std::ostream &stream, const Exactly &number)
{
  return stream << number.value;
}
} // namespace exactNumber

//! \return For `CHECK(x == exactly(0.5))`.
inline exactNumber::Exactly exactly(double value)
{
  return {value};
}

#endif
