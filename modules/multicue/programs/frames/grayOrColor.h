// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsGrayOrColor_h
#define programsGrayOrColor_h

#include <visp3/core/vpImage.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpRGBa.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! Calls a function with an image, or with its gray levels.
template <typename Function> void inGrayOrColor(const vpImage<vpRGBa> &I, bool gray, const Function &function)
{
  if (!gray) {
    function(I);
    return;
  }
  vpImage<unsigned char> levels;
  vpImageConvert::convert(I, levels);
  function(levels);
}

} // namespace programs
#endif
