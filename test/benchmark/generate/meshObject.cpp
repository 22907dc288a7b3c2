// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/syntheticObject.h"

#include <visp3/model/vpModelReader.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
cv::Mat toMat(const vpImage<vpRGBa> &image)
{
  cv::Mat result(static_cast<int>(image.getHeight()), static_cast<int>(image.getWidth()), CV_8UC3);
  for (int i = 0; i < result.rows; ++i) {
    for (int j = 0; j < result.cols; ++j) {
      const vpRGBa &pixel = image[i][j];
      result.at<cv::Vec3b>(i, j) = cv::Vec3b(pixel.B, pixel.G, pixel.R);
    }
  }
  return result;
}

//! The same number for the same name in every run, so that several meshes can be in one data set. FNV-1a.
int numberOf(const std::string &name)
{
  std::uint32_t hash = 2166136261U;
  for (const char c : name) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  }
  return 1000 + static_cast<int>(hash % 900000U);
}
} // namespace

SyntheticObject makeFromMesh(const std::string &file, double unit)
{
  vpModelOptions options;
  options.unit = unit;
  const vpTrackedModel model = vpModelReader::read(file, options);
  const vpModelAppearance &look = model.appearance();
  SyntheticObject object;
  object.name = file;
  object.id = numberOf(file.substr(file.find_last_of("/\\") + 1));
  object.materials.emplace_back();
  for (const vpImage<vpRGBa> &image : look.images) {
    object.images.push_back(toMat(image));
  }
  for (std::size_t t = 0; t < model.triangles().size(); ++t) {
    ColoredTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.position[i] = model.vertices()[static_cast<std::size_t>(model.triangles()[t].vertex[i])];
      triangle.color[i] = t < look.color.size() ? look.color[t][i] : Eigen::Vector3f(0.65F, 0.63F, 0.6F);
      triangle.texture[i] = t < look.texture.size() ? look.texture[t][i] : Eigen::Vector2f::Zero();
    }
    triangle.image = t < look.image.size() ? look.image[t] : -1;
    object.triangles.push_back(triangle);
  }
  return object;
}

} // namespace bench
