// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCaoParent_h
#define vpCaoParent_h

#include <visp3/se3/vpCompatibility.h>

#include <string>

BEGIN_VISP_NAMESPACE

/*!
  Counts the load() lines of a .cao file that has nothing else but comments.

  The parser of ViSP 3.5 reads the parts of such a file and then fails for want of the sections that may follow them.
  \return 0 where the file has sections of its own, is no .cao file, or cannot be read.
*/
unsigned int countPartsOfCaoParent(const std::string &modelFile);

END_VISP_NAMESPACE
#endif
