// SPDX-License-Identifier: GPL-2.0-or-later
#include "texture/vpTextureChart.h"

#include "mesh/triangleCorners.h"

#include <algorithm>
#include <cmath>
#include <map>

BEGIN_VISP_NAMESPACE

using vpMeshDetail::corner;
using vpMeshDetail::normalOf;

namespace {
// Planes nearer than this share of the diameter, or with normals as near, are one; a boundary between two of its
// steps only costs the edges that run along it.
const double planeStep = 1e-3;

using Key = std::array<long, 5>;

long step(double value)
{
  return std::lround(value / planeStep);
}

Key planeKey(const vpTrackedModel &model, const vpModelTriangle &triangle, const Eigen::Vector3d &normal)
{
  const double offset = normal.dot(corner(model, triangle, 0)) / model.diameter();
  return {{-1, step(normal.x()), step(normal.y()), step(normal.z()), step(offset)}};
}

// The charts of a curved face overlap, so that no edge is lost along their borders: each has what looks less than 60
// degrees away from its axis. What is found twice falls together in a view, which keeps one of the two.
const double leastAlongAxis = 0.5;

//! Charts by what their triangles have in common, in the order in which they are met.
class ChartTable
{
public:
  void add(const Key &key, const Eigen::Vector3d &normal, int triangle, bool oriented)
  {
    const auto place = m_known.emplace(key, charts.size());
    if (place.second) {
      charts.emplace_back();
      charts.back().normal = normal;
    }
    vpTextureChart &chart = charts[place.first->second];
    chart.triangles.push_back(triangle);
    chart.oriented = chart.oriented && oriented;
  }

  void addCurved(int face, const Eigen::Vector3d &normal, int triangle, bool oriented)
  {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fabs(normal[axis]) > leastAlongAxis) {
        const int sign = normal[axis] < 0. ? -1 : 1;
        add({{face, axis, sign, 0, 0}}, sign * Eigen::Vector3d::Unit(axis), triangle, oriented);
      }
    }
  }

  std::vector<vpTextureChart> charts;

private:
  std::map<Key, std::size_t> m_known;
};

float grayOf(const Eigen::Vector3f &color)
{
  return 255.F * color.dot(Eigen::Vector3f(0.2126F, 0.7152F, 0.0722F)); // As vpImageConvert weighs them.
}

// True where the chart has an image or corners of different gray levels.
bool hasContrast(const vpTrackedModel &model, const vpTextureChart &chart, double minContrast)
{
  const vpModelAppearance &look = model.appearance();
  float low = 255.F;
  float high = 0.F;
  for (const int triangle : chart.triangles) {
    const std::size_t t = static_cast<std::size_t>(triangle);
    if (t < look.image.size() && look.image[t] >= 0) {
      return true;
    }
    for (std::size_t k = 0; k < 3 && t < look.color.size(); ++k) {
      low = std::min(low, grayOf(look.color[t][k]));
      high = std::max(high, grayOf(look.color[t][k]));
    }
  }
  return high - low >= static_cast<float>(minContrast);
}
} // namespace

std::vector<vpTextureChart> vpMakeTextureCharts(const vpTrackedModel &model, double minContrast)
{
  if (model.appearance().color.empty() && model.appearance().images.empty()) {
    return {};
  }
  ChartTable table;
  for (std::size_t t = 0; t < model.triangles().size(); ++t) {
    const vpModelTriangle &triangle = model.triangles()[t];
    const vpModelFace &face = model.faces()[static_cast<std::size_t>(triangle.face)];
    if (face.planar) {
      table.add(planeKey(model, triangle, face.normal), face.normal, static_cast<int>(t), face.oriented);
    } else {
      table.addCurved(triangle.face, normalOf(model, triangle).normalized(), static_cast<int>(t), face.oriented);
    }
  }
  std::vector<vpTextureChart> &charts = table.charts;
  charts.erase(std::remove_if(charts.begin(), charts.end(),
                              [&](const vpTextureChart &chart) { return !hasContrast(model, chart, minContrast); }),
               charts.end());
  return std::move(charts);
}

END_VISP_NAMESPACE
