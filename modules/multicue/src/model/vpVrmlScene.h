// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpVrmlScene_h
#define vpVrmlScene_h

#include <visp3/se3/vpCompatibility.h>

#include <string>
#include <vector>

class SoVRMLGroup;
class SoSeparator;

BEGIN_VISP_NAMESPACE

/*!
  ViSP takes indices and missing points of a VRML scene on trust and passes over what it does not know.
  \return What may be wrong.
  \throw vpException where ViSP would read memory that is not the scene's, leave out a part of it, or misplace one.
*/
std::vector<std::string> requireWholeVrml2(const SoVRMLGroup &scene);

//! Likewise for a scene of VRML 1 or Inventor, before Coin converts it. \throw vpException where indices are wrong.
void requireWholeVrml1(const SoSeparator &scene);

END_VISP_NAMESPACE
#endif
