// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsLikelyCause_h
#define programsLikelyCause_h

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <string>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

/*!
  Tries the mistakes that are often made with units, axes, poses and cameras on an image that does not show the object
  where it should.
  \param tracker With model and camera; as before when this ends. \param cMo Pose at which the object is not seen.
  \return The mistake without which the image shows the object there, and what to do; empty where there is none.
*/
std::string likelyCause(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo);

} // namespace programs
#endif
