// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/printTexture.h"

#include <visp3/se3/vpPoseRandom.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
//! Draws with numbers of one stream.
class Printer
{
public:
  Printer(int width, int height, std::uint64_t seed, std::uint64_t which) : m_random(seed, {0x7072696e74, which})
  {
    m_image.create(height, width, CV_8UC3);
    m_size = std::min(width, height);
  }

  cv::Mat print()
  {
    ground();
    picture();
    for (int i = 0; i < 7; ++i) {
      shape();
    }
    stripes();
    for (int i = 0; i < 5; ++i) {
      text();
    }
    code();
    return m_image;
  }

private:
  double between(double low, double high) { return low + (high - low) * m_random.uniform(); }
  int pixels(double low, double high) { return static_cast<int>(between(low, high) * m_size); }
  cv::Point place()
  {
    return {static_cast<int>(between(0.05, 0.95) * m_image.cols), static_cast<int>(between(0.05, 0.95) * m_image.rows)};
  }
  cv::Scalar color()
  {
    cv::Mat pixel(1, 1, CV_8UC3, cv::Scalar(between(0, 180), between(90, 235), between(60, 245)));
    cv::cvtColor(pixel, pixel, cv::COLOR_HSV2BGR);
    const cv::Vec3b c = pixel.at<cv::Vec3b>(0, 0);
    return {double(c[0]), double(c[1]), double(c[2])};
  }

  void ground()
  {
    const cv::Scalar from = color();
    const cv::Scalar to = color();
    for (int i = 0; i < m_image.rows; ++i) {
      const double share = double(i) / m_image.rows;
      m_image.row(i).setTo(from * (1. - share) + to * share);
    }
  }

  //! A landscape in a frame: sky, sun and hills.
  void picture()
  {
    const int width = pixels(0.5, 0.8);
    const int height = pixels(0.4, 0.6);
    const cv::Rect frame(static_cast<int>(between(0., 1.) * (m_image.cols - width)),
                         static_cast<int>(between(0., 1.) * (m_image.rows - height)), width, height);
    cv::Mat inside = m_image(frame);
    const cv::Mat clouds = cloudTexture(width, height, 4, 4, m_random.index(1U << 30U), 1);
    for (int i = 0; i < height; ++i) {
      for (int j = 0; j < width; ++j) {
        const double c = 150. + 105. * std::clamp(double(clouds.at<float>(i, j)) * 2. - 0.8, 0., 1.);
        inside.at<cv::Vec3b>(i, j) =
            cv::Vec3b(cv::saturate_cast<uchar>(c + 60), cv::saturate_cast<uchar>(c), cv::saturate_cast<uchar>(c - 60));
      }
    }
    cv::circle(inside, {static_cast<int>(between(0.2, 0.8) * width), height / 3}, height / 7, cv::Scalar(60, 220, 250),
               cv::FILLED, cv::LINE_AA);
    for (int hill = 0; hill < 3; ++hill) {
      const cv::Point centre(static_cast<int>(between(0., 1.) * width), static_cast<int>(1.25 * height));
      cv::ellipse(inside, centre, {static_cast<int>(0.5 * width), static_cast<int>(between(0.4, 0.8) * height)}, 0., 0.,
                  360., color() * 0.7, cv::FILLED, cv::LINE_AA);
    }
    cv::rectangle(m_image, frame, cv::Scalar(240, 240, 240), std::max(2, m_size / 80), cv::LINE_AA);
  }

  void shape()
  {
    const cv::Point at = place();
    const int size = pixels(0.04, 0.13);
    const int line = m_random.index(2) == 0 ? static_cast<int>(cv::FILLED) : std::max(2, m_size / 60);
    switch (m_random.index(3)) {
    case 0:
      cv::circle(m_image, at, size, color(), line, cv::LINE_AA);
      break;
    case 1:
      cv::rectangle(m_image, at, at + cv::Point(2 * size, size), color(), line, cv::LINE_AA);
      break;
    default:
      star(at, size);
    }
  }

  void star(const cv::Point &at, int size)
  {
    std::vector<cv::Point> corners;
    const double turn = between(0., 6.28);
    for (int i = 0; i < 10; ++i) {
      const double radius = i % 2 == 0 ? size : 0.45 * size;
      const double angle = turn + i * CV_PI / 5.;
      corners.emplace_back(at.x + static_cast<int>(radius * std::cos(angle)),
                           at.y + static_cast<int>(radius * std::sin(angle)));
    }
    cv::fillPoly(m_image, std::vector<std::vector<cv::Point>>{corners}, color(), cv::LINE_AA);
  }

  void stripes()
  {
    const cv::Point at = place();
    const cv::Scalar c = color();
    const int step = std::max(6, m_size / 30);
    for (int i = 0; i < 6; ++i) {
      cv::line(m_image, at + cv::Point(i * step, 0), at + cv::Point(i * step + m_size / 6, m_size / 5), c, step / 2,
               cv::LINE_AA);
    }
  }

  void text()
  {
    static const std::array<const char *, 12> words = {{"EXTRA", "Crunchy", "500 g", "No. 7", "ORIGINAL", "Jasmin",
                                                        "fragile", "Made with care", "Best before", "NEW", "Tea & Co",
                                                        "12 pieces"}};
    const double scale = between(0.0022, 0.006) * m_size;
    const cv::Point at(static_cast<int>(between(0.02, 0.6) * m_image.cols),
                       static_cast<int>(between(0.1, 0.97) * m_image.rows));
    const cv::Scalar c = m_random.index(2) == 0 ? cv::Scalar::all(between(0, 50)) : cv::Scalar::all(between(215, 255));
    cv::putText(m_image, words[m_random.index(words.size())], at, cv::FONT_HERSHEY_DUPLEX, scale, c,
                std::max(1, static_cast<int>(scale * 1.8)), cv::LINE_AA);
  }

  //! A bar code on white.
  void code()
  {
    const int height = m_size / 6;
    const int width = m_size / 3;
    const cv::Rect field(static_cast<int>(between(0.02, 0.95) * (m_image.cols - width)),
                         static_cast<int>(between(0.02, 0.95) * (m_image.rows - height)), width, height);
    m_image(field).setTo(cv::Scalar::all(245));
    int x = width / 10;
    while (x < width * 9 / 10) {
      const int bar = 1 + static_cast<int>(m_random.index(4)) * std::max(1, m_size / 250);
      cv::rectangle(m_image, cv::Rect(field.x + x, field.y + height / 8, bar, height * 3 / 4), cv::Scalar::all(20),
                    cv::FILLED);
      x += bar + 1 + static_cast<int>(m_random.index(4)) * std::max(1, m_size / 250);
    }
  }

  vpPoseRandom m_random;
  cv::Mat m_image;
  int m_size = 0;
};
} // namespace

cv::Mat printTexture(int width, int height, std::uint64_t seed, std::uint64_t which)
{
  return Printer(width, height, seed, which).print();
}

cv::Mat cloudTexture(int width, int height, int cells, int octaves, std::uint64_t seed, std::uint64_t which)
{
  vpPoseRandom random(seed, {0x636c6f7564, which});
  cv::Mat sum = cv::Mat::zeros(height, width, CV_32F);
  float strength = 0.5F;
  float total = 0.F;
  for (int octave = 0; octave < octaves; ++octave, cells *= 2, strength *= 0.5F) {
    const int larger = std::max(width, height);
    cv::Mat coarse(cells * height / larger + 3, cells * width / larger + 3, CV_32F);
    for (int i = 0; i < coarse.rows; ++i) {
      for (int j = 0; j < coarse.cols; ++j) {
        coarse.at<float>(i, j) = static_cast<float>(random.uniform());
      }
    }
    cv::Mat fine;
    cv::resize(coarse, fine, sum.size(), 0., 0., cv::INTER_CUBIC);
    sum += strength * fine;
    total += strength;
  }
  return sum / total;
}

} // namespace bench
