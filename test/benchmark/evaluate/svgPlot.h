// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSvgPlot_h
#define benchSvgPlot_h

#include <string>
#include <vector>

namespace bench {

//! Lines over an axis, as a piece of SVG.
class SvgPlot
{
public:
  struct Line
  {
    std::string name;
    std::vector<double> x;
    std::vector<double> y; //!< Not finite: the line is interrupted.
  };

  //! \param logarithmic Decades on the vertical axis.
  SvgPlot(const std::string &title, const std::string &xName, const std::string &yName, bool logarithmic = false);

  void setRange(double yLow, double yHigh);
  //! Numbers under the horizontal axis, which covers them; without, they are chosen from the lines.
  void setColumns(const std::vector<double> &x) { m_columns = x; }
  void add(const Line &line) { m_lines.push_back(line); }
  //! A dashed horizontal line.
  void addLimit(double y) { m_limits.push_back(y); }
  std::string svg() const;

  //! The colour of a line, the same in all plots of a page.
  static std::string color(std::size_t index);

private:
  struct Frame;
  std::string axes(const Frame &frame) const;
  std::vector<double> xMarks(const Frame &frame) const;
  std::string polylines(const Line &line, const std::string &color, const Frame &frame) const;

  std::string m_title, m_xName, m_yName;
  bool m_logarithmic;
  double m_yLow = 0.;
  double m_yHigh = 1.;
  std::vector<double> m_columns;
  std::vector<Line> m_lines;
  std::vector<double> m_limits;
};

//! \e text with the characters that HTML and SVG give a meaning replaced.
std::string escaped(const std::string &text);

} // namespace bench
#endif
