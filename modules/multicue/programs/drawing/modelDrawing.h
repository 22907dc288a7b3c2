// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsModelDrawing_h
#define programsModelDrawing_h

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/multicue/vpTrackingState.h>

#include <opencv2/core.hpp>

#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*!
  \file modelDrawing.h
  Models, features and text over 8-bit BGR images, without a display. Colours are blue, green, red.
*/

namespace programs {

//! Green, orange or red for TRACKING, UNCERTAIN and LOST.
cv::Scalar colorOf(vpTrackingState state);

/*!
  Draws the visible lines of a tracker's model.
  \param tracker Any with getModelForDisplay(): ours or one of ViSP's. \param thickness Pixels.
*/
template <typename Tracker>
void drawModel(cv::Mat &image, Tracker &tracker, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
               const cv::Scalar &color, int thickness);

//! Draws features as getFeaturesForDisplay() gives them: used ones in white, refused ones in red.
void drawFeatures(cv::Mat &image, const std::vector<std::vector<double>> &features);

//! Draws lines of text with a dark rim. \param at Left end of the first line's baseline, pixels.
void drawText(cv::Mat &image, const std::vector<std::string> &lines, const cv::Point &at, const cv::Scalar &color);

//! Draws one of getModelForDisplay()'s rows: its kind, then row and column of both ends of a line.
void drawModelLine(cv::Mat &image, const std::vector<double> &line, const cv::Scalar &color, int thickness);

template <typename Tracker>
void drawModel(cv::Mat &image, Tracker &tracker, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
               const cv::Scalar &color, int thickness)
{
  const auto width = static_cast<unsigned int>(image.cols);
  const auto height = static_cast<unsigned int>(image.rows);
  for (const std::vector<double> &line : tracker.getModelForDisplay(width, height, cMo, cam)) {
    drawModelLine(image, line, color, thickness);
  }
}

} // namespace programs
#endif
