// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/foreground.h"

#include "generate/printTexture.h"
#include "generate/sprite.h"

#include <visp3/se3/vpPoseRandom.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {
const int spriteSize = 256;
//! Less than what may be hidden, because planning looks at coarse pixels.
const double mostHidden = 0.35;

cv::Point2d centreOf(const cv::Rect &box)
{
  return {box.x + 0.5 * box.width - 0.5, box.y + 0.5 * box.height - 0.5};
}

//! Value of a series between its entries, and its first or last one beyond them.
template <typename Value> Value between(const std::vector<Value> &series, double time)
{
  const double inside = std::clamp(time, 0., static_cast<double>(series.size() - 1));
  const std::size_t k = std::min(static_cast<std::size_t>(inside), series.size() - 2);
  const double share = inside - static_cast<double>(k);
  return series[k] * (1. - share) + series[k + 1] * share;
}

//! A print in the outline of a blob with a few lobes.
Sprite makeBlob(std::uint64_t seed)
{
  vpPoseRandom random(seed, {0x626c6f62});
  Sprite sprite;
  sprite.color = printTexture(spriteSize, spriteSize, seed, 100);
  cv::GaussianBlur(sprite.color, sprite.color, cv::Size(), 0.8);
  cv::Mat mask = cv::Mat::zeros(spriteSize, spriteSize, CV_8U);
  std::vector<cv::Point> outline;
  const double phase2 = 2. * M_PI * random.uniform();
  const double phase3 = 2. * M_PI * random.uniform();
  for (int i = 0; i < 90; ++i) {
    const double angle = 2. * M_PI * i / 90.;
    const double radius = 92. * (1. + 0.22 * std::sin(2. * angle + phase2) + 0.12 * std::sin(3. * angle + phase3));
    outline.emplace_back(static_cast<int>(128. + radius * std::cos(angle)),
                         static_cast<int>(128. + radius * std::sin(angle)));
  }
  cv::fillPoly(mask, std::vector<std::vector<cv::Point>>{outline}, cv::Scalar(255), cv::LINE_AA);
  cv::GaussianBlur(mask, mask, cv::Size(), 0.7);
  mask.convertTo(sprite.alpha, CV_32F, 1. / 255.);
  return sprite;
}

class Occluder : public Foreground
{
public:
  Occluder(const SceneCamera &camera, const std::vector<ImageLayer> &object, std::uint64_t seed)
      : m_camera(camera), m_sprite(makeBlob(seed))
  {
    vpPoseRandom random(seed, {0x6f63636c});
    m_turn = 2. * M_PI * random.uniform();
    m_phase = 2. * M_PI * random.uniform();
    double size = 0.;
    for (const ImageLayer &layer : object) {
      m_centre.push_back(centreOf(layer.area));
      size += std::sqrt(static_cast<double>(layer.area.area())) / static_cast<double>(object.size());
    }
    m_size = size;
    planScale(object);
  }

  void draw(double time, cv::Mat &image, cv::Mat &hidden) const override
  {
    m_sprite.draw(map(time, between(m_scale, time)), image, hidden);
  }

private:
  cv::Matx23d map(double time, double scale) const
  {
    // It comes from the side, so that a tracker sees the whole object at the start.
    const double start = 0.7 * std::exp(-std::max(0., time) / 10.);
    const cv::Point2d offset((start + 0.62 * std::cos(2. * M_PI * time / 83.)) * m_size,
                             0.33 * m_size * std::sin(2. * M_PI * time / 131. + m_phase));
    const cv::Point2d at = between(m_centre, time) + offset;
    const double angle = m_turn + 0.5 * std::sin(2. * M_PI * time / 97.);
    const double s = scale * m_size / spriteSize;
    const double c = s * std::cos(angle);
    const double d = s * std::sin(angle);
    const double middle = spriteSize / 2.;
    return {c, -d, at.x - c * middle + d * middle, d, c, at.y - d * middle - c * middle};
  }

  double hiddenShare(const ImageLayer &layer, double time, double scale) const
  {
    // A quarter of the resolution, in the object's own box.
    const int step = std::max(1, static_cast<int>(std::lround(4. * m_camera.scale())));
    cv::Matx23d small = map(time, scale);
    small(0, 2) -= layer.area.x;
    small(1, 2) -= layer.area.y;
    small *= 1. / step;
    cv::Mat whole;
    cv::Mat alpha;
    const cv::Size size(layer.area.width / step + 1, layer.area.height / step + 1);
    cv::resize(layer.coverage, whole, size, 0., 0., cv::INTER_AREA);
    cv::warpAffine(m_sprite.alpha, alpha, small, size, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
    return whole.dot(alpha) / std::max(1., cv::sum(whole)[0]);
  }

  //! The largest size that hides no more than it may, now and in the frames around, smoothed over them.
  void planScale(const std::vector<ImageLayer> &object)
  {
    const int count = static_cast<int>(object.size());
    std::vector<double> most;
    for (int k = 0; k < count; ++k) {
      double low = 0.05;
      double high = 1.15;
      for (int i = 0; i < 8; ++i) {
        const double middle = 0.5 * (low + high);
        (hiddenShare(object[static_cast<std::size_t>(k)], k, middle) <= mostHidden ? low : high) = middle;
      }
      most.push_back(low);
    }
    const int reach = 7;
    const auto at = [&](const std::vector<double> &series, int k) {
      return series[static_cast<std::size_t>(std::clamp(k, 0, count - 1))];
    };
    std::vector<double> least = most;
    for (int k = 0; k < count; ++k) {
      for (int d = -reach; d <= reach; ++d) {
        least[static_cast<std::size_t>(k)] = std::min(least[static_cast<std::size_t>(k)], at(most, k + d));
      }
    }
    for (int k = 0; k < count; ++k) {
      double sum = 0.;
      double weights = 0.;
      for (int d = -reach; d <= reach; ++d) {
        const double weight = 1. + std::cos(M_PI * d / (reach + 1.));
        sum += weight * at(least, k + d);
        weights += weight;
      }
      m_scale.push_back(sum / weights);
    }
  }

  SceneCamera m_camera;
  Sprite m_sprite;
  std::vector<cv::Point2d> m_centre; //!< Of the object per frame.
  std::vector<double> m_scale;       //!< Per frame.
  double m_size = 0.;                //!< Mean size of the object, pixels.
  double m_turn = 0.;
  double m_phase = 0.;
};

class Board : public Foreground
{
public:
  Board(const SceneCamera &camera, const std::vector<ImageLayer> &object, std::uint64_t seed) : m_camera(camera)
  {
    for (const ImageLayer &layer : object) {
      m_centre.push_back(centreOf(layer.area).x);
    }
    vpPoseRandom random(seed, {0x626f617264});
    const int count = static_cast<int>(object.size());
    double widest = 0.;
    for (double middle = 50.; middle < count; middle += 100.) {
      m_middle.push_back(middle + std::floor(11. * random.uniform()) - 5.);
      m_direction.push_back(random.index(2) == 0 ? 1. : -1.);
      for (int k = static_cast<int>(m_middle.back()) - 7; k <= static_cast<int>(m_middle.back()) + 7; ++k) {
        widest = std::max(widest, double(object[static_cast<std::size_t>(std::clamp(k, 0, count - 1))].area.width));
      }
    }
    m_speed = 30. * camera.scale();
    drawBoard(static_cast<int>(widest + 9.5 * m_speed), seed);
  }

  void draw(double time, cv::Mat &image, cv::Mat &hidden) const override
  {
    for (std::size_t i = 0; i < m_middle.size(); ++i) {
      const double offset = m_direction[i] * m_speed * (time - m_middle[i]);
      const double left = between(m_centre, time) + offset - 0.5 * m_board.color.cols;
      if (left < m_camera.width && left + m_board.color.cols > 0.) {
        m_board.draw({1., 0., left, 0., 1., -16.}, image, hidden);
      }
    }
  }

private:
  //! Planks of wood with a grain.
  void drawBoard(int width, std::uint64_t seed)
  {
    const int height = static_cast<int>(m_camera.height) + 32;
    cv::Mat grain = cloudTexture(8 * 40, height, 6, 5, seed, 31);
    cv::resize(grain, grain, cv::Size(width, height), 0., 0., cv::INTER_LINEAR);
    m_board.color.create(height, width, CV_8UC3);
    const int plank = std::max(8, height / 5);
    for (int i = 0; i < height; ++i) {
      const double tone = (0.8 + 0.2 * ((i / plank * 7) % 4) / 3.) * (i % plank < std::max(1, plank / 40) ? 0.4 : 1.);
      for (int j = 0; j < width; ++j) {
        const double g = 60. + 150. * double(grain.at<float>(i, j));
        m_board.color.at<cv::Vec3b>(i, j) =
            cv::Vec3b(cv::saturate_cast<uchar>(0.55 * g * tone), cv::saturate_cast<uchar>(0.8 * g * tone),
                      cv::saturate_cast<uchar>(1.1 * g * tone));
      }
    }
    m_board.alpha = cv::Mat::zeros(height, width, CV_32F);
    m_board.alpha(cv::Rect(1, 1, width - 2, height - 2)).setTo(1.F);
  }

  SceneCamera m_camera;
  Sprite m_board;
  std::vector<double> m_centre;    //!< Column of the object per frame.
  std::vector<double> m_middle;    //!< Time at which the board's middle is before the object's, frames.
  std::vector<double> m_direction; //!< 1 for a board that moves to the right.
  double m_speed = 0.;             //!< Relative to the object, pixels per frame.
};
} // namespace

std::unique_ptr<Foreground> makeOccluder(const SceneCamera &camera, const std::vector<ImageLayer> &object,
                                         std::uint64_t seed)
{
  return std::make_unique<Occluder>(camera, object, seed);
}

std::unique_ptr<Foreground> makeBoard(const SceneCamera &camera, const std::vector<ImageLayer> &object,
                                      std::uint64_t seed)
{
  return std::make_unique<Board>(camera, object, seed);
}

} // namespace bench
