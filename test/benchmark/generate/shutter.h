// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchShutter_h
#define benchShutter_h

#include <opencv2/core.hpp>

#include <functional>

namespace bench {

//! When the rows of an image see light. Times are in frames, 0 in the middle of the image's exposure.
struct Shutter
{
  double exposure = 0.; //!< How long each row sees light.
  double readout = 0.;  //!< From the first row to the last; 0 for a global shutter.

  //! Middle of a row's exposure. \param row Centre of the first row: 0.
  double timeOfRow(double row, int rows) const { return readout * ((row + 0.5) / rows - 0.5); }
};

/*!
  The mean, for each row, of what there was to be seen during its exposure.
  \param imageAt Renders the whole image at a time; 32-bit floats, always of the same size. Its second argument counts
  the calls.
*/
cv::Mat expose(const Shutter &shutter, const std::function<cv::Mat(double, int)> &imageAt);

} // namespace bench
#endif
