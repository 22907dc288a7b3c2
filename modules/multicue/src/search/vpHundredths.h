// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpHundredths_h
#define vpHundredths_h

#include <visp3/se3/vpCompatibility.h>

#include <cstdio>
#include <string>

BEGIN_VISP_NAMESPACE

//! \return A number for a sentence, to two decimals.
inline std::string vpHundredths(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

END_VISP_NAMESPACE
#endif
