// SPDX-License-Identifier: GPL-2.0-or-later
#include "texture/vpEdgePixels.h"
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <cmath>
#include <numeric>

BEGIN_VISP_NAMESPACE

namespace {
const double sigma = 1.; // Pixels.
const int radius = 3;
// Neighbours of one chain have gradients that differ by less than about 37 degrees.
const double sameDirection = 0.8;

// Changes of less than this share of an edge's own do not count as print beside it.
const double besideShare = 0.15;

std::array<float, 2 * radius + 1> gaussian()
{
  std::array<float, 2 * radius + 1> kernel;
  float sum = 0.F;
  for (int i = -radius; i <= radius; ++i) {
    kernel[static_cast<std::size_t>(i + radius)] = static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += kernel[static_cast<std::size_t>(i + radius)];
  }
  for (float &weight : kernel) {
    weight /= sum;
  }
  return kernel;
}

// Of a step of height 1 in the pixels' means, after smoothing and differences of two pixels: what a gradient's
// length is to be divided by to give the step's height.
double gradientOfStep()
{
  const double spread = std::sqrt(sigma * sigma + 1. / 12. + 1. / 3.);
  return 1. / (std::sqrt(2. * M_PI) * spread);
}
} // namespace

vpEdgePixels::vpEdgePixels(const vpChartImage &image, double minContrast)
    : m_width(image.width()), m_height(image.height())
{
  smooth(image);
  differentiate();
  findMaxima(minContrast);
}

void vpEdgePixels::smooth(const vpChartImage &image)
{
  const std::array<float, 2 *radius + 1> kernel = gaussian();
  const std::size_t size = static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
  std::vector<float> rows(size, 0.F);
  std::vector<char> rowsInside(size, 0);
  for (int y = 0; y < m_height; ++y) {
    for (int x = radius; x < m_width - radius; ++x) {
      char inside = 1;
      float sum = 0.F;
      for (int i = -radius; i <= radius; ++i) {
        inside = inside && image.isUsable(x + i, y);
        sum += kernel[static_cast<std::size_t>(i + radius)] * image.gray(x + i, y);
      }
      rows[index(x, y)] = sum;
      rowsInside[index(x, y)] = inside;
    }
  }
  m_smooth.assign(size, 0.F);
  m_inside.assign(size, 0);
  for (int y = radius; y < m_height - radius; ++y) {
    for (int x = 0; x < m_width; ++x) {
      char inside = 1;
      float sum = 0.F;
      for (int i = -radius; i <= radius; ++i) {
        inside = inside && rowsInside[index(x, y + i)];
        sum += kernel[static_cast<std::size_t>(i + radius)] * rows[index(x, y + i)];
      }
      m_smooth[index(x, y)] = sum;
      m_inside[index(x, y)] = inside;
    }
  }
}

void vpEdgePixels::differentiate()
{
  m_gradient.assign(m_smooth.size(), Eigen::Vector2f::Zero());
  m_magnitude.assign(m_smooth.size(), 0.F);
  for (int y = 1; y < m_height - 1; ++y) {
    for (int x = 1; x < m_width - 1; ++x) {
      if (m_inside[index(x - 1, y)] && m_inside[index(x + 1, y)] && m_inside[index(x, y - 1)] &&
          m_inside[index(x, y + 1)]) {
        Eigen::Vector2f &gradient = m_gradient[index(x, y)];
        gradient = 0.5F * Eigen::Vector2f(m_smooth[index(x + 1, y)] - m_smooth[index(x - 1, y)],
                                          m_smooth[index(x, y + 1)] - m_smooth[index(x, y - 1)]);
        m_magnitude[index(x, y)] = gradient.norm();
      }
    }
  }
}

double vpEdgePixels::slope(const Eigen::Vector2d &place, const Eigen::Vector2d &direction) const
{
  const int left = static_cast<int>(place.x());
  const int top = static_cast<int>(place.y());
  const double a = place.x() - left;
  const double b = place.y() - top;
  const auto at = [&](int x, int y) { return m_gradient[index(x, y)].cast<double>().dot(direction); };
  return (1. - b) * ((1. - a) * at(left, top) + a * at(left + 1, top)) +
         b * ((1. - a) * at(left, top + 1) + a * at(left + 1, top + 1));
}

void vpEdgePixels::findMaxima(double minContrast)
{
  const double unit = gradientOfStep();
  m_pixelAt.assign(m_magnitude.size(), -1);
  for (int y = 2; y < m_height - 3; ++y) {
    for (int x = 2; x < m_width - 3; ++x) {
      const double here = m_magnitude[index(x, y)];
      if (!(here >= minContrast * unit)) {
        continue;
      }
      const Eigen::Vector2d direction = m_gradient[index(x, y)].cast<double>() / here;
      const double ahead = slope(Eigen::Vector2d(x, y) + direction, direction);
      const double behind = slope(Eigen::Vector2d(x, y) - direction, direction);
      // Beside the surface the gradient is not known, and a maximum there is none.
      if (!(here > ahead && here >= behind) || vpIsZero(ahead) || vpIsZero(behind)) {
        continue;
      }
      const double offset = 0.5 * (ahead - behind) / (2. * here - behind - ahead);
      vpEdgePixel pixel;
      pixel.place = Eigen::Vector2d(x, y) + offset * direction;
      pixel.gradient = direction;
      pixel.contrast = here / unit;
      m_pixelAt[index(x, y)] = static_cast<int>(m_pixels.size());
      m_pixels.push_back(pixel);
    }
  }
}

double vpEdgePixels::clearance(const vpEdgePixel &pixel, const Eigen::Vector2d &towards, double largest) const
{
  const double own = pixel.contrast * gradientOfStep();
  double least = own;
  double before = own;
  bool found = false;
  for (double distance = 0.5; distance < largest; distance += 0.5) {
    const Eigen::Vector2d place = pixel.place + distance * towards;
    const bool inside = place.x() >= 0. && place.y() >= 0. && place.x() < m_width - 1. && place.y() < m_height - 1.;
    if (!inside) {
      break; // What is beyond the surface's border is the geometry's concern.
    }
    // With its sign: on the other side of a thin line it is opposite, and in between zero.
    const double here = slope(place, pixel.gradient);
    if (found && std::fabs(here) <= std::fabs(before)) {
      return distance - 0.5;
    }
    found = found || here < -besideShare * own || here > least + besideShare * own;
    least = std::min(least, std::max(here, 0.));
    before = here;
  }
  return largest;
}

double vpEdgePixels::clearance(const vpEdgePixel &pixel, double largest) const
{
  return std::min(clearance(pixel, pixel.gradient, largest), clearance(pixel, -pixel.gradient, largest));
}

// The free neighbour that continues best in a direction, -1 for none.
int vpEdgePixels::next(int from, const Eigen::Vector2d &towards, const std::vector<char> &taken) const
{
  const vpEdgePixel &pixel = m_pixels[static_cast<std::size_t>(from)];
  const int column = static_cast<int>(std::lround(pixel.place.x()));
  const int row = static_cast<int>(std::lround(pixel.place.y()));
  int best = -1;
  double least = 0.;
  // Two pixels around the rounded place reach all neighbours of the pixel that it was found at.
  for (int y = std::max(row - 2, 0); y <= std::min(row + 2, m_height - 1); ++y) {
    for (int x = std::max(column - 2, 0); x <= std::min(column + 2, m_width - 1); ++x) {
      const int other = m_pixelAt[index(x, y)];
      if (other < 0 || taken[static_cast<std::size_t>(other)]) {
        continue;
      }
      const vpEdgePixel &candidate = m_pixels[static_cast<std::size_t>(other)];
      const Eigen::Vector2d step = candidate.place - pixel.place;
      const double along = step.dot(towards);
      const double beside = std::fabs(step.dot(Eigen::Vector2d(-towards.y(), towards.x())));
      if (along <= 0.2 || beside > along || candidate.gradient.dot(pixel.gradient) < sameDirection) {
        continue;
      }
      const double cost = along + 2. * beside;
      if (best < 0 || cost < least) {
        best = other;
        least = cost;
      }
    }
  }
  return best;
}

std::vector<std::vector<int>> vpEdgePixels::chains() const
{
  std::vector<int> order(m_pixels.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [this](int a, int b) {
    return m_pixels[static_cast<std::size_t>(a)].contrast > m_pixels[static_cast<std::size_t>(b)].contrast;
  });
  std::vector<std::vector<int>> chains;
  std::vector<char> taken(m_pixels.size(), 0);
  for (const int seed : order) {
    if (taken[static_cast<std::size_t>(seed)]) {
      continue;
    }
    taken[static_cast<std::size_t>(seed)] = 1;
    std::vector<int> chain = {seed};
    for (const double sense : {1., -1.}) {
      for (int at = seed; at >= 0;) {
        const Eigen::Vector2d &gradient = m_pixels[static_cast<std::size_t>(at)].gradient;
        at = next(at, sense * Eigen::Vector2d(-gradient.y(), gradient.x()), taken);
        if (at >= 0) {
          taken[static_cast<std::size_t>(at)] = 1;
          chain.push_back(at);
        }
      }
      std::reverse(chain.begin(), chain.end()); // The second half goes on from the seed, the other way.
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

END_VISP_NAMESPACE
