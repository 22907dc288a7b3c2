// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpLocalStatistics_h
#define vpLocalStatistics_h

#include <visp3/cues/vpColorCue.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>

BEGIN_VISP_NAMESPACE

/*!
  Means and covariances of the colours on both sides of a line's contour ([P14] III-B). \tparam N Channels, 1 or 3.
*/
template <int N> class vpLocalStatistics
{
public:
  using Vector = Eigen::Matrix<float, N, 1>;
  using Matrix = Eigen::Matrix<float, N, N>;

  //! Sums over the pixels of one side.
  struct Sums
  {
    float count = 0.F;
    Vector first = Vector::Zero();
    Matrix second = Matrix::Zero();

    Vector mean() const { return first / std::max(count, 1.F); }
    Matrix covariance() const
    {
      const Vector m = mean();
      return second / std::max(count, 1.F) - m * m.transpose();
    }
  };

  static Vector color(std::uint32_t pixel)
  {
    Vector color;
    for (int i = 0; i < N; ++i) {
      color[i] = static_cast<float>((pixel >> (8 * i)) & 0xFFU);
    }
    return color;
  }

  //! Sums over the pixels at offsets from \e from to \e to, as far as the line has them.
  static Sums sum(const std::uint32_t *pixels, const vpColorCue::Line &line, int from, int to)
  {
    Sums sums;
    for (int k = std::max(from, line.first); k <= std::min(to, line.last); ++k) {
      const Vector c = color(pixels[k]);
      sums.count += 1.F;
      sums.first += c;
      sums.second += c * c.transpose();
    }
    return sums;
  }
};

END_VISP_NAMESPACE
#endif
