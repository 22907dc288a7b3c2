// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMbTrackerNames_h
#define vpMbTrackerNames_h

#include <visp3/core/vpConfig.h>

// A protected member of vpMbTracker got its prefix in ViSP 3.6. Only for sources that use it.
#if VISP_VERSION_INT < VP_VERSION_INT(3, 6, 0)
#define m_isoJoIdentity isoJoIdentity
#endif

#endif
