// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/objectRenderer.h"

#include <visp3/model/vpModelReader.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {

ObjectRenderer::ObjectRenderer(const LoadedObject &object, const SceneCamera &camera)
    : m_object(object), m_camera(camera), m_renderer(object.model), m_shadow(object.model)
{
}

cv::Rect ObjectRenderer::boundingBox(const vpHomogeneousMatrix &cMo) const
{
  double left = std::numeric_limits<double>::max();
  double top = left;
  double right = -left;
  double bottom = -left;
  for (const Eigen::Vector3d &p : m_object.model->vertices()) {
    Eigen::Vector3d c;
    for (unsigned int i = 0; i < 3; ++i) {
      c(i) = cMo[i][0] * p.x() + cMo[i][1] * p.y() + cMo[i][2] * p.z() + cMo[i][3];
    }
    const double u = m_camera.cam.get_u0() + m_camera.cam.get_px() * c.x() / c.z();
    const double v = m_camera.cam.get_v0() + m_camera.cam.get_py() * c.y() / c.z();
    left = std::min(left, u);
    right = std::max(right, u);
    top = std::min(top, v);
    bottom = std::max(bottom, v);
  }
  const int x = static_cast<int>(std::floor(left + 0.5));
  const int y = static_cast<int>(std::floor(top + 0.5));
  return {x, y, static_cast<int>(std::floor(right + 0.5)) + 1 - x, static_cast<int>(std::floor(bottom + 0.5)) + 1 - y};
}

Eigen::Vector3f ObjectRenderer::shadeSample(std::size_t sample, const Eigen::Vector3f &ray, const Light &light) const
{
  SurfacePoint point;
  point.camera = ray * m_view.depth[sample];
  point.object = m_oRc * point.camera + m_oTc;
  point.normal = m_view.normal[sample];
  const vpRGBa &color = m_view.color[sample];
  point.color << color.B, color.G, color.R;
  const SurfaceMaterial &material = m_object.materials[static_cast<std::size_t>(m_view.face[sample])];
  return shade(point, material, light, m_shadow, m_oRc);
}

void ObjectRenderer::render(const vpHomogeneousMatrix &cMo, const Light &light, int samples, ImageLayer &layer)
{
  layer.area = boundingBox(cMo);
  layer.color = cv::Mat::zeros(layer.area.size(), CV_32FC3);
  layer.coverage = cv::Mat::zeros(layer.area.size(), CV_32F);
  m_shadow.update(cMo, light.toLight);
  const vpHomogeneousMatrix oMc = cMo.inverse();
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      m_oRc(i, j) = static_cast<float>(oMc[i][j]);
    }
    m_oTc(i) = static_cast<float>(oMc[i][3]);
  }
  // The crop alone is the renderer's image. A pixel's square goes from -0.5 to 0.5 about its centre, enlarged from
  // -0.5 to samples - 0.5.
  const double s = samples;
  const vpCameraParameters cam(s * m_camera.cam.get_px(), s * m_camera.cam.get_py(),
                               s * (m_camera.cam.get_u0() - layer.area.x + 0.5) - 0.5,
                               s * (m_camera.cam.get_v0() - layer.area.y + 0.5) - 0.5);
  vpRenderOptions options;
  options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL | vpRenderOptions::FACE | vpRenderOptions::COLOR;
  m_renderer.render(cMo, cam, static_cast<unsigned int>(samples * layer.area.width),
                    static_cast<unsigned int>(samples * layer.area.height), options, m_view);
  const float share = 1.F / static_cast<float>(samples * samples);
  std::size_t sample = 0;
  for (int i = 0; i < m_view.height; ++i) {
    const int row = (m_view.top + i) / samples;
    for (int j = 0; j < m_view.width; ++j, ++sample) {
      if (m_view.depth[sample] <= 0.F) {
        continue;
      }
      const int column = (m_view.left + j) / samples;
      const Eigen::Vector3f ray(static_cast<float>((m_view.left + j - cam.get_u0()) / cam.get_px()),
                                static_cast<float>((m_view.top + i - cam.get_v0()) / cam.get_py()), 1.F);
      const Eigen::Vector3f seen = share * shadeSample(sample, ray, light);
      layer.color.at<cv::Vec3f>(row, column) += cv::Vec3f(seen.x(), seen.y(), seen.z());
      layer.coverage.at<float>(row, column) += share;
    }
  }
}

namespace {
//! The part of the object's triangle whose middle is nearest: the reader reorders and welds, but moves nothing.
int nearestPart(const SyntheticObject &object, const Eigen::Vector3d &centre)
{
  int part = 0;
  double nearest = std::numeric_limits<double>::max();
  for (const ColoredTriangle &triangle : object.triangles) {
    const Eigen::Vector3d middle = (triangle.position[0] + triangle.position[1] + triangle.position[2]) / 3.;
    const double distance = (middle - centre).squaredNorm();
    if (distance < nearest) {
      nearest = distance;
      part = triangle.part;
    }
  }
  return part;
}
} // namespace

void writeObject(const std::string &dataset, const SyntheticObject &object, const std::string &folder)
{
  programs::BopModel files;
  files.id = object.id;
  files.triangles.assign(object.triangles.begin(), object.triangles.end());
  files.images = object.images;
  files.cao = object.cao;
  files.folder = folder;
  programs::writeBopModel(dataset, files);
}

LoadedObject writeAndLoad(const std::string &dataset, const SyntheticObject &object, const std::string &folder)
{
  writeObject(dataset, object, folder);
  vpModelOptions options;
  options.maxSize = 1000.;
  const std::string path = programs::bopModelPath(dataset, object.id, folder);
  options.unit = object.images.empty() ? 0.001 : 1.;
  LoadedObject loaded;
  loaded.model = std::make_shared<const vpTrackedModel>(
      vpModelReader::read(path + (object.images.empty() ? ".ply" : ".obj"), options));
  loaded.materials.resize(loaded.model->faces().size());
  std::vector<char> known(loaded.materials.size(), object.materials.size() == 1 ? 1 : 0);
  std::fill(loaded.materials.begin(), loaded.materials.end(), object.materials.front());
  for (const vpModelTriangle &triangle : loaded.model->triangles()) {
    const std::size_t face = static_cast<std::size_t>(triangle.face);
    if (known[face]) {
      continue;
    }
    known[face] = 1;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (const int vertex : triangle.vertex) {
      centre += loaded.model->vertices()[static_cast<std::size_t>(vertex)] / 3.;
    }
    loaded.materials[face] = object.materials[static_cast<std::size_t>(nearestPart(object, centre))];
  }
  return loaded;
}

} // namespace bench
