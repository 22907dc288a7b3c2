// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsPictureFile_h
#define programsPictureFile_h

#include <opencv2/core.hpp>

#include <string>

namespace programs {

//! Writes a picture as a whole or not at all. \param file Its extension tells the format. \throw vpException naming the
//! file that cannot be written, or that OpenCV has no writer for.
void writePicture(const std::string &file, const cv::Mat &picture);

} // namespace programs
#endif
