// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsImageFile_h
#define programsImageFile_h

#include <opencv2/core.hpp>

#include <string>

namespace programs {

//! How many bits of 16 the images of a sequence use: the brightness of all of them is to be the same.
struct ImageDepth
{
  int bits = 0; //!< 0 as long as no image of 16 bits was read.
};

/*!
  \param file Path.
  \param depth Of the images before, which the first one of 16 bits sets: 10, 12, 14 or all 16.
  \return Eight bits each of blue, green and red, in the pixels as they are stored: a camera matrix belongs to those, so
  that the orientation that a tag in the file asks for does not count.
  \throw vpException naming the file that is no image, has floating-point pixels, or more bits than the first one.
*/
cv::Mat readColorImage(const std::string &file, ImageDepth &depth);
//! An image on its own. \return Empty where it cannot be read.
cv::Mat readColorImage(const std::string &file);

} // namespace programs
#endif
