// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCompatibility_h
#define vpCompatibility_h

#include <visp3/core/vpConfig.h>

/*!
  \file vpCompatibility.h
  The differences between the ViSP versions that are supported (3.5, 3.6 and 3.7), in one place.
*/

#ifndef BEGIN_VISP_NAMESPACE
#define BEGIN_VISP_NAMESPACE
#define END_VISP_NAMESPACE
#endif

#endif
