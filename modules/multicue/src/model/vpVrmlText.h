// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpVrmlText_h
#define vpVrmlText_h

#include <visp3/se3/vpCompatibility.h>

#include <string>

BEGIN_VISP_NAMESPACE

/*!
  Coin believes what it reads: it recurses as deep as brackets are nested, allocates what a binary file says, unpacks
  compressed files, and reads the files that a file names, itself included. Looks at the text before Coin does.
  \throw vpException with line number where \e modelFile is not to be handed over.
*/
void requireHarmlessVrml(const std::string &modelFile);

END_VISP_NAMESPACE
#endif
