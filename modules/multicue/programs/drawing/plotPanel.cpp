// SPDX-License-Identifier: GPL-2.0-or-later
#include "drawing/plotPanel.h"

#include "drawing/modelDrawing.h"

#include <visp3/core/vpMath.h>
#include <visp3/core/vpThetaUVector.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace programs {
namespace {
const int margin = 6;
const int stripCount = 4;
const int titleHeight = 16;
const int statesHeight = 3;
const std::size_t mostFrames = PlotPanel::width - 2 * margin; // One column each.
const cv::Scalar paper(30, 30, 30), ink(200, 200, 200);
const cv::Scalar axes[] = {{80, 80, 255}, {80, 220, 80}, {255, 160, 60}}; // x, y, z as red, green, blue.

double coordinate(const PlottedFrame &frame, unsigned int axis)
{
  return frame.cMo[axis][3];
}

double turn(const PlottedFrame &frame, unsigned int axis)
{
  vpThetaUVector thetaU;
  frame.cMo.extract(thetaU);
  return vpMath::deg(thetaU[axis]);
}
} // namespace

struct PlotPanel::Strip
{
  std::string title;
  std::string format; //!< printf's, of one number.
  std::vector<std::function<double(const PlottedFrame &)>> curves;
  bool fromZero = false;
  double least = 0.; //!< Smallest range that is shown, so that noise does not fill the strip.
  cv::Rect area;
};

void PlotPanel::add(const PlottedFrame &frame)
{
  m_frames.push_back(frame);
  if (m_frames.size() > mostFrames) {
    m_frames.pop_front();
  }
}

void PlotPanel::drawStates(cv::Mat &panel, const cv::Rect &area) const
{
  for (std::size_t k = 0; k < m_frames.size(); ++k) {
    const int x = area.x + static_cast<int>(k);
    cv::line(panel, {x, area.y}, {x, area.y + area.height}, colorOf(m_frames[k].state), 1);
  }
}

void PlotPanel::drawStrip(cv::Mat &panel, const Strip &strip) const
{
  double low = strip.fromZero ? 0. : strip.curves.front()(m_frames.front());
  double high = low;
  for (const PlottedFrame &frame : m_frames) {
    for (const auto &curve : strip.curves) {
      low = std::min(low, curve(frame));
      high = std::max(high, curve(frame));
    }
  }
  const double range = std::max(high - low, strip.least);
  const cv::Rect plot(strip.area.x, strip.area.y + titleHeight, strip.area.width,
                      strip.area.height - titleHeight - statesHeight - 2);
  std::string title = strip.title;
  for (std::size_t c = 0; c < strip.curves.size(); ++c) {
    const cv::Scalar color = strip.curves.size() == 1 ? ink : axes[c];
    std::vector<cv::Point> line;
    for (std::size_t k = 0; k < m_frames.size(); ++k) {
      const double share = (strip.curves[c](m_frames[k]) - low) / range;
      line.emplace_back(plot.x + static_cast<int>(k), plot.y + plot.height - cvRound(share * plot.height));
    }
    cv::polylines(panel, line, false, color, 1, cv::LINE_AA);
    title += " " + cv::format(strip.format.c_str(), strip.curves[c](m_frames.back()));
  }
  cv::putText(panel, title, {strip.area.x, strip.area.y + titleHeight - 4}, cv::FONT_HERSHEY_SIMPLEX, 0.4, ink, 1,
              cv::LINE_AA);
  drawStates(panel, {plot.x, plot.y + plot.height + 2, plot.width, statesHeight});
}

cv::Mat PlotPanel::draw(int height) const
{
  cv::Mat panel(height, width, CV_8UC3, paper);
  if (m_frames.empty()) {
    return panel;
  }
  const auto ofAxes = [](double (*value)(const PlottedFrame &, unsigned int)) {
    std::vector<std::function<double(const PlottedFrame &)>> curves;
    for (unsigned int axis = 0; axis < 3; ++axis) {
      curves.emplace_back([value, axis](const PlottedFrame &frame) { return value(frame, axis); });
    }
    return curves;
  };
  std::vector<Strip> strips = {
      {"x y z, m", "%.3f", ofAxes(coordinate), false, 0.02, {}},
      {"theta u, deg", "%.1f", ofAxes(turn), false, 5., {}},
      {"score", "%.2f", {[](const PlottedFrame &frame) { return frame.score; }}, true, 1., {}},
      {"ms", "%.1f", {[](const PlottedFrame &frame) { return frame.milliseconds; }}, true, 10., {}}};
  const int stripHeight = height / stripCount;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    strips[i].area = {margin, static_cast<int>(i) * stripHeight, width - 2 * margin, stripHeight - margin};
    drawStrip(panel, strips[i]);
  }
  return panel;
}

} // namespace programs
