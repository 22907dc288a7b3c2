// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsCheckedStart_h
#define programsCheckedStart_h

#include "check/checkReport.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <optional>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! Reads a start pose. \return Nothing where it is none.
std::optional<vpHomogeneousMatrix> readStart(const std::string &file, CheckReport &report);

/*!
  Whether the camera can see the object at the start pose, and whether the image shows it there; if not, which mistake
  explains it. \param tracker With model and camera. \return True where tracking can start.
*/
bool checkStart(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
                CheckReport &report);

//! What each cue finds of the object in an image where it starts.
void checkCues(vpMbMultiCueTracker &tracker, const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo,
               CheckReport &report);

} // namespace programs
#endif
