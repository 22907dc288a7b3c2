// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef initialPose_h
#define initialPose_h

#include <visp3/core/vpHomogeneousMatrix.h>

#include <string>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*!
  \param file Text of numbers with # comments: 6 of them, translation (metres) and theta u (radians) as in ViSP's .pos
  files, or 12 or 16, the rows of a matrix.
  \return The pose.
  \throw vpException naming the file and what is wrong with it.
*/
vpHomogeneousMatrix readPose(const std::string &file);

#endif
