// SPDX-License-Identifier: GPL-2.0-or-later
#include "demo/demoPicture.h"

#include "drawing/modelDrawing.h"

#include <visp3/core/vpImageConvert.h>

#include <opencv2/imgproc.hpp>

namespace programs {
namespace {
const int titleHeight = 32;
const int border = 4; // In the colour of the state.
const cv::Scalar white(255, 255, 255), paper(30, 30, 30);
const std::size_t lettersPerLine = 72;

// A text in lines that fit into half a picture.
std::vector<std::string> wrapped(const std::string &text)
{
  std::vector<std::string> lines;
  std::string rest = text;
  while (rest.size() > lettersPerLine) {
    const std::size_t at = rest.rfind(' ', lettersPerLine);
    lines.push_back(rest.substr(0, at));
    rest = "  " + rest.substr(at + 1);
  }
  lines.push_back(rest);
  return lines;
}
} // namespace

cv::Mat demoHalf(const vpImage<vpRGBa> &I, DemoTracker &tracker, const DemoAnswer &answer,
                 const DemoRecord::Frame &frame, bool hasTruth)
{
  cv::Mat image;
  vpImageConvert::convert(I, image);
  tracker.draw(image, answer);
  const cv::Scalar color = colorOf(answer.state);
  cv::rectangle(image, cv::Rect(0, 0, image.cols, image.rows), color, border);
  drawText(image, {tracker.name()}, {12, 24}, white);
  std::string state = toString(answer.state);
  if (hasTruth && frame.isShown) {
    state += frame.isRight ? cv::format(", right: off by %.1f mm", 1000. * frame.translation)
                           : cv::format(", wrong: off by %.0f mm, %.0f deg", 1000. * frame.translation, frame.rotation);
  } else if (hasTruth) {
    state += ", the object is hidden";
  }
  drawText(image, {cv::format("%d  ", frame.number) + state}, {12, image.rows - 14}, color);
  return image;
}

cv::Mat demoPicture(const std::string &title, const cv::Mat &left, const cv::Mat &right)
{
  cv::Mat picture;
  cv::hconcat(left, right, picture);
  cv::copyMakeBorder(picture, picture, titleHeight, 0, 0, 0, cv::BORDER_CONSTANT, paper);
  drawText(picture, {title}, {12, 21}, white);
  return picture;
}

cv::Mat demoSummary(const std::string &title, const DemoRecord &left, const DemoRecord &right, const cv::Size &size)
{
  cv::Mat picture(size, CV_8UC3, paper);
  drawText(picture, {title}, {12, 21}, white);
  int x = 12;
  for (const DemoRecord *record : {&left, &right}) {
    std::vector<std::string> text = {record->tracker(), ""};
    for (const std::string &line : record->summary()) {
      for (const std::string &part : wrapped(line)) {
        text.push_back(part);
      }
    }
    drawText(picture, text, {x, size.height / 3}, white);
    x += size.width / 2;
  }
  return picture;
}

} // namespace programs
