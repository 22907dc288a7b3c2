// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsCheckedCamera_h
#define programsCheckedCamera_h

#include "check/checkReport.h"

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/multicue/vpConfigReport.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! \param config What was taken of the configuration. \param I Empty where there is no image.
//! \return True where the camera can have taken the image.
bool checkCamera(const vpCameraParameters &cam, const vpConfigReport &config, const vpImage<vpRGBa> &I,
                 CheckReport &report);

//! Whether an image shows anything.
void checkImage(const vpImage<vpRGBa> &I, CheckReport &report);

} // namespace programs
#endif
