// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchGenerateOptions_h
#define benchGenerateOptions_h

#include "generate/scene.h"

namespace bench {

//! The command line of multicue-generate.
struct GenerateOptions
{
  std::vector<std::string> objects;
  std::vector<std::string> variants;
  SceneOptions scene; //!< All but object and variant.

  /*!
    \return False where only help was asked for, which was printed then.
    \throw vpException naming the option that is unknown, misses its value or has a wrong one.
  */
  bool read(int argc, const char *const argv[]);

private:
  void check() const;
};

} // namespace bench
#endif
