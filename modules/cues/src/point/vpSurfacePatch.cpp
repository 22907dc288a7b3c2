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
// The correlation of a patch with itself under noise of a quarter of its contrast is 0.94.
const float leastCorrelation = 0.75F;
// Standard deviation of the gray levels below which there is nothing to see.
const float leastContrast = 2.F;
const int maxIterations = 12;
const float converged = 0.01F; // Pixels.

using Window = std::array<float, count>;

// Weights of the four pixels around a place between them.
struct Fraction
{
  Fraction(float x, float y)
      : upperLeft((1.F - x) * (1.F - y)), upperRight(x * (1.F - y)), lowerLeft((1.F - x) * y), lowerRight(x * y)
  {
  }
  float operator()(const unsigned char *upper, const unsigned char *lower) const
  {
    return upperLeft * static_cast<float>(upper[0]) + upperRight * static_cast<float>(upper[1]) +
           lowerLeft * static_cast<float>(lower[0]) + lowerRight * static_cast<float>(lower[1]);
  }
  float upperLeft, upperRight, lowerLeft, lowerRight;
};

// Takes off the mean. Returns the length of what is left.
float centre(Window &window)
{
  float sum = 0.F;
  for (const float value : window) {
    sum += value;
  }
  float squares = 0.F;
  for (float &value : window) {
    value -= sum / count;
    squares += value * value;
  }
  return std::sqrt(squares);
}

float dot(const Window &a, const Window &b)
{
  float sum = 0.F;
  for (std::size_t i = 0; i < count; ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

void scale(Window &window, float by)
{
  for (float &value : window) {
    value *= by;
  }
}

// A patch as it is expected, without mean and of unit length, and how that changes when it moves.
struct Expected
{
  Window values, alongX, alongY;
  Eigen::Matrix2f inverse;

  bool prepare(const float *wide)
  {
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const float *p = wide + (i + 1) * wideSide + j + 1;
        const std::size_t at = static_cast<std::size_t>(i * side + j);
        values[at] = *p;
        alongX[at] = 0.5F * (p[1] - p[-1]);
        alongY[at] = 0.5F * (p[wideSide] - p[-wideSide]);
      }
    }
    const float length = centre(values);
    if (length < leastContrast * side) {
      return false;
    }
    scale(values, 1.F / length);
    for (Window *gradient : {&alongX, &alongY}) {
      // The part that brightness and contrast could explain says nothing of motion.
      centre(*gradient);
      scale(*gradient, 1.F / length);
      const float share = dot(*gradient, values);
      for (std::size_t i = 0; i < count; ++i) {
        (*gradient)[i] -= share * values[i];
      }
    }
    Eigen::Matrix2f information;
    information(0, 0) = dot(alongX, alongX);
    information(1, 1) = dot(alongY, alongY);
    information(0, 1) = information(1, 0) = dot(alongX, alongY);
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
  const Fraction between(left - static_cast<float>(column), top - static_cast<float>(row));
  float *value = window.data();
  for (int i = 0; i < side; ++i) {
    const unsigned char *upper = pixels.ptr<unsigned char>(row + i) + column;
    const unsigned char *lower = pixels.ptr<unsigned char>(row + i + 1) + column;
    for (int j = 0; j < side; ++j) {
      *value++ = between(upper + j, lower + j);
    }
  }
  return true;
}
} // namespace

void vpSurfacePatch::take(const cv::Mat &pixels, const cv::Point2f &place)
{
  const int column = static_cast<int>(std::floor(place.x));
  const int row = static_cast<int>(std::floor(place.y));
  const Fraction between(place.x - static_cast<float>(column), place.y - static_cast<float>(row));
  const auto inside = [](int x, int size) { return std::min(std::max(x, 0), size - 1); };
  std::size_t at = 0;
  for (int i = row - storedHalf; i <= row + storedHalf; ++i) {
    const unsigned char *upper = pixels.ptr<unsigned char>(inside(i, pixels.rows));
    const unsigned char *lower = pixels.ptr<unsigned char>(inside(i + 1, pixels.rows));
    for (int j = column - storedHalf; j <= column + storedHalf; ++j) {
      const int left = inside(j, pixels.cols);
      const int right = inside(j + 1, pixels.cols);
      const unsigned char above[2] = {upper[left], upper[right]};
      const unsigned char below[2] = {lower[left], lower[right]};
      m_stored[at++] = static_cast<unsigned char>(between(above, below) + 0.5F);
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
      *values++ = Fraction(x - static_cast<float>(column), y - static_cast<float>(row))(upper, upper + storedSide);
    }
  }
  return true;
}

bool vpSurfacePatch::align(const cv::Mat &pixels, const Eigen::Matrix2d &distortion, float reach,
                           cv::Point2f &place) const
{
  std::array<float, wideSide * wideSide> wide;
  Expected expected;
  if (!isSimilar(distortion) || !warp(distortion, wide.data()) || !expected.prepare(wide.data())) {
    return false;
  }
  const cv::Point2f start = place;
  Window window;
  for (int iteration = 0; iteration < maxIterations; ++iteration) {
    if (!sample(pixels, place, window)) {
      return false;
    }
    const float length = centre(window);
    if (length < leastContrast * side) {
      return false;
    }
    // The gradients are perpendicular to the expected values: those need not be taken off the window.
    const Eigen::Vector2f error(dot(window, expected.alongX), dot(window, expected.alongY));
    const Eigen::Vector2f step = expected.inverse * error / length;
    const float correlation = dot(window, expected.values) / length;
    if (step.norm() < converged) {
      return correlation > leastCorrelation;
    }
    place -= cv::Point2f(step.x(), step.y());
    if (!(std::hypot(place.x - start.x, place.y - start.y) < reach)) {
      return false;
    }
  }
  return false;
}

END_VISP_NAMESPACE
