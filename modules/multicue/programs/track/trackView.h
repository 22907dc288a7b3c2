// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsTrackView_h
#define programsTrackView_h

#include "drawing/plotPanel.h"
#include "track/trackKeys.h"
#include "track/trackingLog.h"

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include <string>
#include <vector>

namespace programs {

//! Makes the picture that is shown and saved: the image with what the tracker says, and plots beside it.
class TrackView
{
public:
  explicit TrackView(bool plots) : m_plots(plots) {}

  //! An image before the object is tracked, with text and marked points. \param marks Rows and columns.
  cv::Mat untracked(const vpImage<vpRGBa> &I, const std::vector<std::string> &text,
                    const std::vector<vpImagePoint> &marks = {}) const;
  //! \param tracker After its track().
  cv::Mat tracked(const vpImage<vpRGBa> &I, vpMbMultiCueTracker &tracker, const TrackedFrame &frame,
                  const ViewState &view);

private:
  cv::Mat withPanel(const cv::Mat &image) const;

  bool m_plots;
  PlotPanel m_panel;
};

} // namespace programs
#endif
