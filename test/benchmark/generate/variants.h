// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchVariants_h
#define benchVariants_h

#include <string>
#include <vector>

namespace bench {

/*!
  What makes a sequence difficult: "regular" (nothing), "light" (direction and strength change), "noise" (Gaussian, 12
  gray levels), "occlusion" (up to 0.4 hidden), "blur" (exposure of 0.6 of the frame interval), "blackout" (hidden for
  10 to 15 frames), "exit" (outside the image for 10 to 20 frames), "webcam" (all of effectNames()).
*/
std::vector<std::string> variantNames();

//! \return True where a variant is \e name, or is joined of it and others.
bool hasVariant(const std::string &variant, const std::string &name);

//! \throw vpException naming the part of a variant that there is not.
void checkVariant(const std::string &variant);

} // namespace bench
#endif
