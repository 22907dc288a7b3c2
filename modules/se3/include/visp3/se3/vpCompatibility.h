// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCompatibility_h
#define vpCompatibility_h

#include <visp3/core/vpConfig.h>

/*!
  \file vpCompatibility.h
  The differences between the ViSP versions that are supported (3.5, 3.6 and 3.7), in one place. Only the new name of
  one protected member of vpMbTracker is elsewhere, beside the two sources that use it: it takes a macro, which must not
  reach users.
*/

#ifndef BEGIN_VISP_NAMESPACE
#define BEGIN_VISP_NAMESPACE
#define END_VISP_NAMESPACE
#endif

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_se3
  True where vpMe parameters hold their threshold in gray levels (ViSP 3.6 and later, where asked for).
*/
template <typename Me>
auto vpMeHasNormalizedThreshold(const Me &me) -> decltype(me.getLikelihoodThresholdType() == Me::NORMALIZED_THRESHOLD)
{
  return me.getLikelihoodThresholdType() == Me::NORMALIZED_THRESHOLD;
}
//! Chosen where ViSP knows one scale only, the old one.
template <typename... Any> bool vpMeHasNormalizedThreshold(const Any &...)
{
  return false;
}

END_VISP_NAMESPACE

#endif
