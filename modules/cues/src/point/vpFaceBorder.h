// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFaceBorder_h
#define vpFaceBorder_h

#include <visp3/core/vpConfig.h>
#include <visp3/se3/vpCompatibility.h>

#include <opencv2/core.hpp>

BEGIN_VISP_NAMESPACE

//! Where points of a face may lie.
namespace vpFaceBorder {
/*!
  Takes off the border of each face. Where a wide one would leave nothing of a face, it is 5 pixels there: ViSP's
  trackers, too, go on with a face that is smaller than its border, and a small object would have no points else.
  \param mask 0 between the faces. \param border Pixels.
*/
void takeOff(cv::Mat &mask, int border);
} // namespace vpFaceBorder

END_VISP_NAMESPACE
#endif
