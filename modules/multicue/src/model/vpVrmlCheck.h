// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpVrmlCheck_h
#define vpVrmlCheck_h

#include <visp3/se3/vpCompatibility.h>

#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  ViSP takes it for granted that Coin understood a .wrl file, and crashes where it did not: asks Coin first.
  \return What may be wrong with the file.
  \throw vpException where Coin cannot read \e modelFile.
*/
std::vector<std::string> requireReadableVrml(const std::string &modelFile);

END_VISP_NAMESPACE
#endif
