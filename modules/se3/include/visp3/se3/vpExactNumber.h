// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpExactNumber_h
#define vpExactNumber_h

#include <visp3/se3/vpCompatibility.h>

#include <functional>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_se3
  True where two numbers are the same to the last bit, but for the sign of zero; never for NaN. For numbers that were
  handed on and not computed: a setting that was changed or not, a value that stands for "none". What was computed is
  compared with a tolerance.
*/
inline bool vpIsSame(double a, double b)
{
  return std::equal_to<double>()(a, b);
}

//! \ingroup group_se3
//! The contrary of vpIsSame().
inline bool vpIsOther(double a, double b)
{
  return !vpIsSame(a, b);
}

//! \ingroup group_se3 True for zero alone, of either sign: where it says that there is nothing, as in a depth buffer,
//! or where it would be divided by.
inline bool vpIsZero(double value)
{
  return vpIsSame(value, 0.);
}

END_VISP_NAMESPACE
#endif
