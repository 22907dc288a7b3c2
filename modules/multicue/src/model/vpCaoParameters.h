// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCaoParameters_h
#define vpCaoParameters_h

#include "model/vpCaoFile.h"

#include <string_view>

BEGIN_VISP_NAMESPACE

/*!
  Reads name=, useLod=, minLineLengthThreshold= and minPolygonAreaThreshold= after the numbers of a line. As in ViSP,
  other words end them and are passed over.
  \throw vpException naming the parameter where its value is none.
*/
void readCaoParameters(std::string_view text, vpCaoShape &shape);

//! A line load("part.cao", t=[x; y; z], tu=[x deg; y deg; z deg]) of a .cao file; t and tu are optional.
struct vpCaoLoad
{
  std::string file; //!< Path of the part.
  vpHomogeneousMatrix pose;

  //! \param parent Path of the file with the line. \throw vpException where the line is broken or the part is missing.
  static vpCaoLoad parse(const std::string &line, const std::string &parent);
};

END_VISP_NAMESPACE
#endif
