// SPDX-License-Identifier: GPL-2.0-or-later
#include "point/vpSurfacePatch.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
constexpr int side = 2 * vpSurfacePatch::half + 1;
constexpr int count = side * side;
constexpr int wideSide = side + 2; // With the neighbours that gradients need.
// How much larger or smaller a patch may appear, in the direction in which it changes most.
const double largestStretch = 1.5;
// Standard deviation of the gray levels below which there is nothing to see.
const float leastContrast = 2.F;
const int maxIterations = 12;
const float converged = 0.01F; // Pixels.

// In whole packets of four numbers; those beyond the last pixel stay 0.
constexpr int padded = (count + 3) / 4 * 4;
using Window = Eigen::Matrix<float, padded, 1>;

// From the first to the second by a share of the way.
float between(float from, float to, float share)
{
  return from + share * (to - from);
}

void takeOffMean(Window &window)
{
  const float mean = window.sum() / count;
  window.head<count>().array() -= mean;
}

// A patch as it is expected, without mean and of unit length, and how that changes when it moves.
struct Expected
{
  Window values, alongX, alongY;
  Eigen::Matrix2f inverse;

  bool prepare(const float *wide)
  {
    values.setZero();
    alongX.setZero();
    alongY.setZero();
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const float *p = wide + (i + 1) * wideSide + j + 1;
        values[i * side + j] = *p;
        alongX[i * side + j] = 0.5F * (p[1] - p[-1]);
        alongY[i * side + j] = 0.5F * (p[wideSide] - p[-wideSide]);
      }
    }
    takeOffMean(values);
    const float length = values.norm();
    if (length < leastContrast * side) {
      return false;
    }
    values /= length;
    for (Window *gradient : {&alongX, &alongY}) {
      // The part that brightness and contrast could explain says nothing of motion.
      takeOffMean(*gradient);
      *gradient /= length;
      *gradient -= gradient->dot(values) * values;
    }
    Eigen::Matrix2f information;
    information(0, 0) = alongX.squaredNorm();
    information(1, 1) = alongY.squaredNorm();
    information(0, 1) = information(1, 0) = alongX.dot(alongY);
    // A patch that is known along one direction only.
    if (!(information.determinant() > 1e-3F * information.trace() * information.trace())) {
      return false;
    }
    inverse = information.inverse();
    return true;
  }
};

bool sample(const cv::Mat &pixels, const cv::Point2f &place, Window &window)
{
  const float left = place.x - vpSurfacePatch::half;
  const float top = place.y - vpSurfacePatch::half;
  const float room = side + 1;
  if (!(left >= 0.F && top >= 0.F && left + room < static_cast<float>(pixels.cols) &&
        top + room < static_cast<float>(pixels.rows))) {
    return false;
  }
  const int column = static_cast<int>(left);
  const int row = static_cast<int>(top);
  const float right = left - static_cast<float>(column);
  const float down = top - static_cast<float>(row);
  // Each row between its pixels once, for the rows of the window above and below it.
  std::array<float, side> above{};
  std::array<float, side> below{};
  for (int i = -1; i < side; ++i) {
    const unsigned char *p = pixels.ptr<unsigned char>(row + i + 1) + column;
    for (int j = 0; j < side; ++j) {
      below[static_cast<std::size_t>(j)] = between(p[j], p[j + 1], right);
    }
    for (int j = 0; i >= 0 && j < side; ++j) {
      window[i * side + j] = between(above[static_cast<std::size_t>(j)], below[static_cast<std::size_t>(j)], down);
    }
    above = below;
  }
  return true;
}
} // namespace

void vpSurfacePatch::take(const cv::Mat &pixels, const cv::Point2f &place)
{
  const int column = static_cast<int>(std::floor(place.x));
  const int row = static_cast<int>(std::floor(place.y));
  const float right = place.x - static_cast<float>(column);
  const float down = place.y - static_cast<float>(row);
  const auto inside = [](int x, int size) { return std::min(std::max(x, 0), size - 1); };
  std::size_t at = 0;
  for (int i = row - storedHalf; i <= row + storedHalf; ++i) {
    const unsigned char *upper = pixels.ptr<unsigned char>(inside(i, pixels.rows));
    const unsigned char *lower = pixels.ptr<unsigned char>(inside(i + 1, pixels.rows));
    for (int j = column - storedHalf; j <= column + storedHalf; ++j) {
      const int first = inside(j, pixels.cols);
      const int second = inside(j + 1, pixels.cols);
      const float level =
          between(between(upper[first], upper[second], right), between(lower[first], lower[second], right), down);
      m_stored[at++] = static_cast<unsigned char>(level + 0.5F);
    }
  }
}

bool vpSurfacePatch::isSimilar(const Eigen::Matrix2d &distortion)
{
  // Singular values from the trace and the determinant of its square.
  const double squares = distortion.squaredNorm();
  const double product = distortion.determinant();
  const double root = std::sqrt(std::max(squares * squares - 4. * product * product, 0.));
  const double largest = 0.5 * (squares + root);
  const double smallest = 0.5 * (squares - root);
  const double limit = largestStretch * largestStretch;
  return product > 0. && largest < limit && smallest * limit > 1.;
}

bool vpSurfacePatch::warp(const Eigen::Matrix2d &distortion, float *values) const
{
  const Eigen::Matrix2f back = distortion.inverse().cast<float>();
  const float reach = (half + 1) * back.cwiseAbs().rowwise().sum().maxCoeff();
  if (!(reach < storedHalf)) {
    return false;
  }
  for (int i = -half - 1; i <= half + 1; ++i) {
    for (int j = -half - 1; j <= half + 1; ++j) {
      const float x = back(0, 0) * static_cast<float>(j) + back(0, 1) * static_cast<float>(i) + storedHalf;
      const float y = back(1, 0) * static_cast<float>(j) + back(1, 1) * static_cast<float>(i) + storedHalf;
      const int column = static_cast<int>(x);
      const int row = static_cast<int>(y);
      const unsigned char *upper = m_stored.data() + row * storedSide + column;
      const unsigned char *lower = upper + storedSide;
      const float right = x - static_cast<float>(column);
      *values++ =
          between(between(upper[0], upper[1], right), between(lower[0], lower[1], right), y - static_cast<float>(row));
    }
  }
  return true;
}

bool vpSurfacePatch::align(const cv::Mat &pixels, const Eigen::Matrix2d &distortion, const Limits &limits,
                           cv::Point2f &place) const
{
  std::array<float, wideSide * wideSide> wide;
  Expected expected;
  if (!isSimilar(distortion) || !warp(distortion, wide.data()) || !expected.prepare(wide.data())) {
    return false;
  }
  const cv::Point2f start = place;
  Window window = Window::Zero();
  for (int iteration = 0; iteration < maxIterations; ++iteration) {
    if (!sample(pixels, place, window)) {
      return false;
    }
    // Values and gradients have no mean, and the gradients are perpendicular to the values: what they are multiplied
    // with needs neither its mean nor the values taken off.
    const float mean = window.sum() / count;
    const float length = std::sqrt(std::max(window.squaredNorm() - count * mean * mean, 0.F));
    if (length < leastContrast * side) {
      return false;
    }
    const Eigen::Vector2f error(window.dot(expected.alongX), window.dot(expected.alongY));
    const Eigen::Vector2f step = expected.inverse * error / length;
    const float correlation = window.dot(expected.values) / length;
    if (step.norm() < converged) {
      return correlation > limits.leastCorrelation;
    }
    place -= cv::Point2f(step.x(), step.y());
    if (!(std::hypot(place.x - start.x, place.y - start.y) < limits.reach)) {
      return false;
    }
  }
  return false;
}

END_VISP_NAMESPACE
