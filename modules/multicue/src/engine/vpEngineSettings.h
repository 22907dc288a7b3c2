// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEngineSettings_h
#define vpEngineSettings_h

#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

//! Settings that belong to no part alone. Those of a part are the part's.
struct vpEngineSettings
{
  bool searches = false;           //!< For an object that is lost.
  double goodRatio = 0.4;          //!< Share of the features that the state TRACKING needs.
  bool computesCovariance = false; //!< For the user.
};

END_VISP_NAMESPACE
#endif
