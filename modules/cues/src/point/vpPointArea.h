// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointArea_h
#define vpPointArea_h

#include "point/vpPointCamera.h"

#include <visp3/model/vpModelView.h>

#include <opencv2/core.hpp>

BEGIN_VISP_NAMESPACE

//! Chooses the part of the image that points are looked for in.
namespace vpPointArea {
//! The model's projected box with room for motion, empty where it cannot be seen. \param size Of the image.
cv::Rect expected(const vpModelView &view, const vpPointCamera &camera, const cv::Size &size);

//! The size to use for an area: that of the one before where it is neither too small nor far too large.
cv::Size size(const cv::Rect &needed, const cv::Rect &before, const cv::Size &image);

//! A rectangle of a size in the middle of another one, as far as the image allows.
cv::Rect placed(const cv::Size &size, const cv::Rect &around, const cv::Size &image);
} // namespace vpPointArea

END_VISP_NAMESPACE
#endif
