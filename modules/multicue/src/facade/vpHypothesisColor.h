// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpHypothesisColor_h
#define vpHypothesisColor_h

#include <visp3/core/vpColor.h>
#include <visp3/se3/vpCompatibility.h>

#include <cstddef>

BEGIN_VISP_NAMESPACE

// Of the pose with this rank among several that are displayed.
inline vpColor vpHypothesisColor(std::size_t rank)
{
  // Not green, blue, purple and red, which tell the states of features.
  static const vpColor colors[] = {vpColor::cyan, vpColor::yellow, vpColor::orange, vpColor::lightGreen,
                                   vpColor::lightRed};
  return colors[rank % (sizeof(colors) / sizeof(colors[0]))];
}

END_VISP_NAMESPACE
#endif
