// SPDX-License-Identifier: GPL-2.0-or-later
#include "../render/vpSurfaceShader.h"
#include "texture/vpTextureChart.h"
#include <visp3/se3/vpExactNumber.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

BEGIN_VISP_NAMESPACE

namespace {
// Each pixel is the mean of as many squared: print that is finer than a pixel blurs as it does in a camera.
const int fineness = 3;
// Neighbouring pixels with a larger difference in depth, in pixels, show different layers of the surface.
const double largestSlope = 3.;
} // namespace

//! The chart with smaller pixels; fine pixel (i, j) is at ((j - 1) / fineness, (i - 1) / fineness) of the chart.
struct vpChartImage::FineImage
{
  FineImage(int chartWidth, int chartHeight)
      : width(fineness * chartWidth), height(fineness * chartHeight),
        gray(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.F),
        depth(gray.size(), std::numeric_limits<float>::lowest())
  {
  }

  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  bool covers(std::size_t i) const { return vpIsOther(depth[i], std::numeric_limits<float>::lowest()); }

  //! \param corners Fine pixels, depth in metres.
  void draw(const vpSurfaceShader &shader, int triangle, const std::array<Eigen::Vector3d, 3> &corners)
  {
    Eigen::Matrix3d edges;
    edges << corners[0].x(), corners[1].x(), corners[2].x(), corners[0].y(), corners[1].y(), corners[2].y(), 1., 1., 1.;
    if (!(std::fabs(edges.determinant()) > 1e-9)) {
      return;
    }
    const Eigen::Matrix3d toWeights = edges.inverse();
    const auto range = [&](int axis, int size) {
      const auto at = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
      return std::array<int, 2>{{std::max(static_cast<int>(std::ceil(at.first - 1e-6)), 0),
                                 std::min(static_cast<int>(std::floor(at.second + 1e-6)), size - 1)}};
    };
    const std::array<int, 2> columns = range(0, width);
    const std::array<int, 2> rows = range(1, height);
    for (int y = rows[0]; y <= rows[1]; ++y) {
      for (int x = columns[0]; x <= columns[1]; ++x) {
        const Eigen::Vector3d weights = toWeights * Eigen::Vector3d(x, y, 1.);
        const float z =
            static_cast<float>(weights.dot(Eigen::Vector3d(corners[0].z(), corners[1].z(), corners[2].z())));
        const std::size_t i = index(x, y);
        if (weights.minCoeff() < -1e-9 || !(z > depth[i])) {
          continue;
        }
        const vpRGBa color = shader.color(triangle, weights);
        depth[i] = z;
        gray[i] = static_cast<float>(0.2126 * color.R + 0.7152 * color.G + 0.0722 * color.B);
      }
    }
  }

  int width;
  int height;
  std::vector<float> gray;
  std::vector<float> depth;
};

vpChartImage::vpChartImage(const vpTrackedModel &model, const vpTextureChart &chart, double pixel) : m_pixel(pixel)
{
  place(model, chart);
  FineImage fine(m_width, m_height);
  const vpSurfaceShader shader(model);
  for (const int triangle : chart.triangles) {
    std::array<Eigen::Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const int vertex = model.triangles()[static_cast<std::size_t>(triangle)].vertex[k];
      corners[k] = m_axes.transpose() * (model.vertices()[static_cast<std::size_t>(vertex)] - m_origin);
      corners[k].head<2>() = (corners[k].head<2>().array() * (fineness / m_pixel) + fineness / 2).matrix();
    }
    fine.draw(shader, triangle, corners);
  }
  reduce(fine);
  dropSteps();
}

void vpChartImage::place(const vpTrackedModel &model, const vpTextureChart &chart)
{
  m_axes.col(2) = chart.normal;
  // Along an axis of the object where there is one: print is mostly laid out so, and its edges then run along rows.
  Eigen::Index smallest = 0;
  chart.normal.cwiseAbs().minCoeff(&smallest);
  m_axes.col(0) = chart.normal.cross(Eigen::Vector3d::Unit(smallest)).normalized();
  m_axes.col(1) = chart.normal.cross(m_axes.col(0));
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (const int triangle : chart.triangles) {
    for (const int vertex : model.triangles()[static_cast<std::size_t>(triangle)].vertex) {
      const Eigen::Vector3d p = m_axes.transpose() * model.vertices()[static_cast<std::size_t>(vertex)];
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  const Eigen::Vector3d size = (high - low) / m_pixel;
  m_width = static_cast<int>(std::ceil(size.x())) + 1;
  m_height = static_cast<int>(std::ceil(size.y())) + 1;
  m_origin = m_axes * low;
}

void vpChartImage::reduce(const FineImage &fine)
{
  const std::size_t size = static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height);
  m_gray.assign(size, 0.F);
  m_depth.assign(size, 0.F);
  m_usable.assign(size, 0);
  for (int y = 0; y < m_height; ++y) {
    for (int x = 0; x < m_width; ++x) {
      int covered = 0;
      float sum = 0.F;
      for (int i = 0; i < fineness * fineness; ++i) {
        const std::size_t at = fine.index(fineness * x + i % fineness, fineness * y + i / fineness);
        if (fine.covers(at)) {
          ++covered;
          sum += fine.gray[at];
        }
      }
      if (covered == fineness * fineness) {
        const std::size_t middle = fine.index(fineness * x + fineness / 2, fineness * y + fineness / 2);
        m_gray[index(x, y)] = sum / static_cast<float>(covered);
        m_depth[index(x, y)] = fine.depth[middle];
        m_usable[index(x, y)] = 1;
      }
    }
  }
}

// The border of one layer over another is an edge of the drawing, not of the texture.
void vpChartImage::dropSteps()
{
  const std::vector<char> usable = m_usable;
  const float largest = static_cast<float>(largestSlope * m_pixel);
  const auto compare = [&](std::size_t a, std::size_t b) {
    if (usable[a] && usable[b] && std::fabs(m_depth[a] - m_depth[b]) > largest) {
      m_usable[a] = m_usable[b] = 0;
    }
  };
  for (int y = 0; y < m_height; ++y) {
    for (int x = 0; x < m_width; ++x) {
      if (x + 1 < m_width) {
        compare(index(x, y), index(x + 1, y));
      }
      if (y + 1 < m_height) {
        compare(index(x, y), index(x, y + 1));
      }
    }
  }
}

double vpChartImage::depth(double x, double y) const
{
  const int left = std::min(std::max(static_cast<int>(x), 0), std::max(m_width - 2, 0));
  const int top = std::min(std::max(static_cast<int>(y), 0), std::max(m_height - 2, 0));
  const int right = std::min(left + 1, m_width - 1);
  const int bottom = std::min(top + 1, m_height - 1);
  const double a = x - left;
  const double b = y - top;
  const auto at = [this](int i, int j) { return static_cast<double>(m_depth[index(i, j)]); };
  return (1. - b) * ((1. - a) * at(left, top) + a * at(right, top)) +
         b * ((1. - a) * at(left, bottom) + a * at(right, bottom));
}

Eigen::Vector3d vpChartImage::toObject(double x, double y) const
{
  return m_origin + m_axes * Eigen::Vector3d(x * m_pixel, y * m_pixel, depth(x, y));
}

Eigen::Vector3d vpChartImage::normal(double x, double y, double step) const
{
  const Eigen::Vector3d right = toObject(x + step, y) - toObject(x - step, y);
  const Eigen::Vector3d down = toObject(x, y + step) - toObject(x, y - step);
  return right.cross(down).normalized();
}

END_VISP_NAMESPACE
