// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/svgPlot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace bench {

namespace {
const double width = 520.;
const double height = 240.;
const double left = 56.;
const double right = 120.; // Room for the names of the lines.
const double top = 24.;
const double bottom = 36.;
const std::size_t fewPoints = 12; // Each is marked then.
} // namespace

// Where the axes are, and what they show.
struct SvgPlot::Frame
{
  double xLow, xHigh, yLow, yHigh;
  bool logarithmic;

  double column(double x) const
  {
    return left + (width - left - right) * (xHigh > xLow ? (x - xLow) / (xHigh - xLow) : 0.5);
  }

  double row(double y) const
  {
    const double low = logarithmic ? std::log10(yLow) : yLow;
    const double high = logarithmic ? std::log10(yHigh) : yHigh;
    const double value = logarithmic ? std::log10(std::max(y, yLow)) : y;
    const double share = std::clamp((value - low) / (high - low), 0., 1.);
    return height - bottom - share * (height - top - bottom);
  }
};

std::string escaped(const std::string &text)
{
  std::string result;
  for (const char c : text) {
    switch (c) {
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '&':
      result += "&amp;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  }
  return result;
}

SvgPlot::SvgPlot(const std::string &title, const std::string &xName, const std::string &yName, bool logarithmic)
    : m_title(title), m_xName(xName), m_yName(yName), m_logarithmic(logarithmic)
{
}

void SvgPlot::setRange(double yLow, double yHigh)
{
  m_yLow = yLow;
  m_yHigh = yHigh;
}

std::string SvgPlot::color(std::size_t index)
{
  static const std::array<const char *, 8> colors = {
      {"#1b6ca8", "#d1495b", "#2e8b57", "#e08e0b", "#7b4fa3", "#5c5c5c", "#00a3a3", "#a0522d"}};
  return colors[index % colors.size()];
}

std::string SvgPlot::axes(const Frame &frame) const
{
  std::ostringstream svg;
  svg << "<rect x='" << left << "' y='" << top << "' width='" << width - left - right << "' height='"
      << height - top - bottom << "' fill='none' stroke='#999'/>";
  std::vector<double> marks;
  if (m_logarithmic) {
    for (double mark = m_yLow; mark <= m_yHigh * 1.001; mark *= 10.) {
      marks.push_back(mark);
    }
  } else {
    for (int i = 0; i <= 4; ++i) {
      marks.push_back(m_yLow + 0.25 * i * (m_yHigh - m_yLow));
    }
  }
  for (const double mark : marks) {
    const double y = frame.row(mark);
    svg << "<line x1='" << left << "' x2='" << width - right << "' y1='" << y << "' y2='" << y
        << "' stroke='#e4e4e4'/><text x='" << left - 5. << "' y='" << y + 4. << "' text-anchor='end'>" << mark
        << "</text>";
  }
  for (const double mark : xMarks(frame)) {
    svg << "<text x='" << frame.column(mark) << "' y='" << height - bottom + 14. << "' text-anchor='middle'>" << mark
        << "</text>";
  }
  svg << "<text x='" << 0.5 * (left + width - right) << "' y='" << height - 6. << "' text-anchor='middle'>"
      << escaped(m_xName) << "</text><text transform='translate(12," << 0.5 * (top + height - bottom)
      << ") rotate(-90)' text-anchor='middle'>" << escaped(m_yName) << "</text><text x='" << left << "' y='" << top - 8.
      << "' font-weight='bold'>" << escaped(m_title) << "</text>";
  return svg.str();
}

std::vector<double> SvgPlot::xMarks(const Frame &frame) const
{
  if (!m_columns.empty()) {
    return m_columns;
  }
  if (!m_lines.empty() && m_lines.front().x.size() <= fewPoints) {
    return m_lines.front().x;
  }
  return {frame.xLow, std::round(0.5 * (frame.xLow + frame.xHigh)), frame.xHigh};
}

std::string SvgPlot::polylines(const Line &line, const std::string &color, const Frame &frame) const
{
  std::ostringstream svg;
  std::ostringstream points;
  std::size_t count = 0;
  const auto finish = [&] {
    if (count > 0) {
      svg << "<polyline fill='none' stroke='" << color << "' stroke-width='1.4' points='" << points.str() << "'/>";
    }
    points.str("");
    count = 0;
  };
  const bool few = line.x.size() <= fewPoints;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (!std::isfinite(line.y[i])) {
      finish();
      continue;
    }
    const double x = frame.column(line.x[i]);
    const double y = frame.row(line.y[i]);
    points << x << "," << y << " ";
    ++count;
    if (few) {
      svg << "<circle cx='" << x << "' cy='" << y << "' r='2.5' fill='" << color << "'/>";
    }
  }
  finish();
  return svg.str();
}

std::string SvgPlot::svg() const
{
  Frame frame{HUGE_VAL, -HUGE_VAL, m_yLow, m_yHigh, m_logarithmic};
  for (const double x : m_columns) {
    frame.xLow = std::min(frame.xLow, x);
    frame.xHigh = std::max(frame.xHigh, x);
  }
  for (const Line &line : m_lines) {
    for (const double x : line.x) {
      frame.xLow = std::min(frame.xLow, x);
      frame.xHigh = std::max(frame.xHigh, x);
    }
  }
  std::ostringstream svg;
  svg.precision(5);
  svg << "<svg viewBox='0 0 " << width << " " << height << "' width='" << width << "'>" << axes(frame);
  for (const double limit : m_limits) {
    svg << "<line x1='" << left << "' x2='" << width - right << "' y1='" << frame.row(limit) << "' y2='"
        << frame.row(limit) << "' stroke='#444' stroke-dasharray='4 3'/>";
  }
  for (std::size_t i = 0; i < m_lines.size(); ++i) {
    svg << polylines(m_lines[i], color(i), frame) << "<text x='" << width - right + 8. << "' y='"
        << top + 12. + 15. * static_cast<double>(i) << "' fill='" << color(i) << "'>" << escaped(m_lines[i].name)
        << "</text>";
  }
  svg << "</svg>";
  return svg.str();
}

} // namespace bench
