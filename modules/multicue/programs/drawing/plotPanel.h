// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsPlotPanel_h
#define programsPlotPanel_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/multicue/vpTrackingState.h>

#include <opencv2/core.hpp>

#include <array>
#include <deque>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! What a frame adds to the plots.
struct PlottedFrame
{
  int number = 0;          //!< Of the frame in its source.
  vpHomogeneousMatrix cMo; //!< Object to camera, metres.
  double score = 0.;       //!< [0, 1].
  double milliseconds = 0.;
  vpTrackingState state = vpTrackingState::UNCERTAIN;
};

//! Plots of pose, score and time over the last frames, drawn into a picture that stands beside the images.
class PlotPanel
{
public:
  static constexpr int width = 280; //!< Pixels.

  void add(const PlottedFrame &frame);
  //! \param height Pixels. \return 8-bit BGR, width x height.
  cv::Mat draw(int height) const;

private:
  struct Strip;

  void drawStrip(cv::Mat &panel, const Strip &strip) const;
  void drawStates(cv::Mat &panel, const cv::Rect &area) const;

  std::deque<PlottedFrame> m_frames; //!< As many as the width shows.
};

} // namespace programs
#endif
