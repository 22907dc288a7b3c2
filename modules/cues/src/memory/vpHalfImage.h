// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpHalfImage_h
#define vpHalfImage_h

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/se3/vpCompatibility.h>

#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

// The means of 2 x 2 pixels, row by row, four bytes each: the channels of a colour, or a gray level four times. The
// last column and row of an odd size are left out.
void vpHalveImage(const vpImage<unsigned char> &I, std::vector<std::uint8_t> &pixels);
void vpHalveImage(const vpImage<vpRGBa> &I, std::vector<std::uint8_t> &pixels);

END_VISP_NAMESPACE
#endif
