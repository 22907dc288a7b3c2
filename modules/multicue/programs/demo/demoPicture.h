// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsDemoPicture_h
#define programsDemoPicture_h

#include "demo/demoRecord.h"

namespace programs {

//! Half of a picture: the image with one tracker's pose, in the colour of its state.
cv::Mat demoHalf(const vpImage<vpRGBa> &I, DemoTracker &tracker, const DemoAnswer &answer,
                 const DemoRecord::Frame &frame, bool hasTruth);

//! Both halves below a title.
cv::Mat demoPicture(const std::string &title, const cv::Mat &left, const cv::Mat &right);

//! A picture with the figures of both, of the size of demoPicture().
cv::Mat demoSummary(const std::string &title, const DemoRecord &left, const DemoRecord &right, const cv::Size &size);

} // namespace programs
#endif
