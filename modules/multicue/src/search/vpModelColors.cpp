// SPDX-License-Identifier: GPL-2.0-or-later
#include "search/vpModelColors.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

namespace {
const std::size_t sampledPlaces = 600;
// Of a vpViewSphere: each place is seen from several of its directions.
const unsigned int level = 1;
// Places that are seen flatter than this show what is beside them.
const float leastFacing = 0.3F;
// Share of the object's depth by which the depth buffer may differ from a place that it shows.
const float sameDepth = 0.02F;
const std::size_t fewestPlaces = 20;
// Variance that noise has, gray levels squared: what varies less correlates with nothing.
const float noise = 16.F;
// Deviation of the model's shades from which on they count fully, gray levels.
const double fullDeviation = 12.;
const double leastTrust = 0.1;
const float fullTint = 100.F;
// The tint of what is darker than this is hardly known, gray levels.
const float darkness = 40.F;

// Brightness, and two channels against the third as shares of it: those of a face in the shade are about the same.
std::array<float, 3> shadeOf(float red, float green, float blue)
{
  const float brightness = 0.25F * (red + 2.F * green + blue);
  const float scale = fullTint / (brightness + darkness);
  return {brightness, scale * (red - green), scale * (blue - green)};
}

// Cells of a cube around the normal's sphere.
std::size_t groupOf(const Eigen::Vector3f &normal)
{
  Eigen::Index axis = 0;
  const float length = normal.cwiseAbs().maxCoeff(&axis);
  if (!(length > 0.F)) {
    return 0;
  }
  const auto cell = [length](float x) {
    return static_cast<std::size_t>(std::min(std::max(std::floor(2.F * (x / length + 1.F)), 0.F), 3.F));
  };
  const std::size_t side = 2 * static_cast<std::size_t>(axis) + (normal[axis] < 0.F ? 1 : 0);
  return 16 * side + 4 * cell(normal[(axis + 1) % 3]) + cell(normal[(axis + 2) % 3]);
}
} // namespace

// Sums over the places in view: brightness about its mean in each group, the rest of the colours about its mean in all.
struct vpModelColors::Sums
{
  struct Mean
  {
    float count = 0.F, x = 0.F, y = 0.F;
  };
  struct Products
  {
    float xx = 0.F, yy = 0.F, xy = 0.F;

    void add(float x, float y)
    {
      xx += x * x;
      yy += y * y;
      xy += x * y;
    }

    void centre(const Mean &mean)
    {
      if (mean.count > 0.F) {
        xx -= mean.x * mean.x / mean.count;
        yy -= mean.y * mean.y / mean.count;
        xy -= mean.x * mean.y / mean.count;
      }
    }

    // Of so many places. What noise alone varies by correlates with nothing.
    float correlation(float places) const
    {
      const float least = noise * places;
      return xy / std::sqrt((std::max(xx, 0.F) + least) * (std::max(yy, 0.F) + least));
    }

    // How much it says: foil and glints vary by much of which the model's colours know nothing.
    float weight(float places) const { return std::max(xx, 0.F) / (std::max(yy, 0.F) + noise * places); }
  };
  std::array<Mean, groups> brightnessMeans;
  std::array<Mean, 2> tintMeans;
  Products brightness, tint;
  float count = 0.F;

  void add(const Shade &model, const Shade &image, std::size_t group)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      Mean &mean = k == 0 ? brightnessMeans[group] : tintMeans[k - 1];
      mean.count += 1.F;
      mean.x += model[k];
      mean.y += image[k];
      (k == 0 ? brightness : tint).add(model[k], image[k]);
    }
    count += 1.F;
  }

  void centre()
  {
    for (const Mean &mean : brightnessMeans) {
      brightness.centre(mean);
    }
    for (const Mean &mean : tintMeans) {
      tint.centre(mean);
    }
  }

  // Of the model's shades, gray levels squared.
  float variance() const { return count > 0.F ? (std::max(brightness.xx, 0.F) + std::max(tint.xx, 0.F)) / count : 0.F; }

  // Mean of both correlations, each as far as it says something.
  float correlation() const
  {
    const float ofBrightness = brightness.weight(count);
    const float ofTint = tint.weight(count);
    const float total = ofBrightness + ofTint;
    return total > 0.F ? (ofBrightness * brightness.correlation(count) + ofTint * tint.correlation(count)) / total
                       : 0.F;
  }
};

void vpModelColors::setModel(std::shared_ptr<const vpTrackedModel> model)
{
  m_model = std::move(model);
  m_places.clear();
  m_isLearnt = false;
  m_trusts.fill(0.);
  if (!m_model || (m_model->appearance().color.empty() && m_model->appearance().images.empty())) {
    return;
  }
  for (const vpSurfaceSample &sample : vpSampleSurface(*m_model, sampledPlaces)) {
    Place place;
    place.position = sample.position;
    place.normal = sample.normal;
    place.bothSides = sample.seenFromBothSides;
    place.group = groupOf(sample.normal);
    m_places.push_back(place);
  }
}

void vpModelColors::setFrame(const vpCueFrame &frame, vpViewSphere &sphere, vpModelRenderer::Preference preference)
{
  if (!m_places.empty() && !m_isLearnt) {
    learn(sphere, *vpModelRenderer::create(m_model, preference));
    m_isLearnt = true;
  }
  m_gray = &frame.gray();
  m_color = frame.hasColor() ? &frame.color() : nullptr;
  m_camera = frame.camera();
}

// What the renderings all around show of each place; those that are never seen are left out.
void vpModelColors::learn(vpViewSphere &sphere, vpModelRenderer &renderer)
{
  vpRenderOptions options;
  options.channels = vpRenderOptions::DEPTH | vpRenderOptions::COLOR;
  vpRenderedView view;
  for (std::size_t i = 0; i < std::min(vpViewSphere::size(level), sphere.size()); ++i) {
    const vpHomogeneousMatrix cMo = sphere.poseOf(i);
    renderer.render(cMo, sphere.camera(), vpViewSphere::imageSize, vpViewSphere::imageSize, options, view);
    learnFrom(view, cMo, sphere.camera());
  }
  m_places.erase(
      std::remove_if(m_places.begin(), m_places.end(), [](const Place &place) { return !(place.weight > 0.F); }),
      m_places.end());
  for (const bool hasColor : {false, true}) {
    const double trust = std::min(1., deviation(hasColor) / fullDeviation);
    m_trusts[hasColor ? 1 : 0] = trust < leastTrust ? 0. : trust;
  }
}

void vpModelColors::learnFrom(const vpRenderedView &view, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam)
{
  const Eigen::Isometry3f pose = vpPoseExponential::toEigen(cMo).cast<float>();
  for (Place &place : m_places) {
    const Eigen::Vector3f at = pose * place.position;
    const float facing = -at.normalized().dot(pose.linear() * place.normal);
    if ((place.bothSides ? std::fabs(facing) : facing) < leastFacing) {
      continue;
    }
    const int i = view.index(cam.get_px() * static_cast<double>(at.x() / at.z()) + cam.get_u0(),
                             cam.get_py() * static_cast<double>(at.y() / at.z()) + cam.get_v0());
    if (i < 0 || std::fabs(view.depth[static_cast<std::size_t>(i)] - at.z()) > sameDepth * at.z()) {
      continue;
    }
    const vpRGBa &color = view.color[static_cast<std::size_t>(i)];
    const Shade shade = shadeOf(color.R, color.G, color.B);
    place.weight += 1.F;
    for (std::size_t k = 0; k < shade.size(); ++k) {
      place.shade[k] += (shade[k] - place.shade[k]) / place.weight;
    }
  }
}

// Of the shades about their means, gray levels.
double vpModelColors::deviation(bool hasColor) const
{
  Sums sums;
  for (const Place &place : m_places) {
    Shade shade = place.shade;
    if (!hasColor) {
      shade[1] = shade[2] = 0.F;
    }
    sums.add(shade, shade, place.group);
  }
  sums.centre();
  return std::sqrt(static_cast<double>(sums.variance()));
}

// Mean over 2 x 2 pixels.
vpModelColors::Shade vpModelColors::shadeAt(int u, int v) const
{
  int red = 0;
  int green = 0;
  int blue = 0;
  for (int k = 0; k < 4; ++k) {
    const unsigned int i = static_cast<unsigned int>(v + k / 2);
    const unsigned int j = static_cast<unsigned int>(u + k % 2);
    if (m_color != nullptr) {
      const vpRGBa &pixel = (*m_color)[i][j];
      red += pixel.R;
      green += pixel.G;
      blue += pixel.B;
    } else {
      green += (*m_gray)[i][j];
    }
  }
  if (m_color == nullptr) {
    return {0.25F * static_cast<float>(green), 0.F, 0.F};
  }
  return shadeOf(0.25F * static_cast<float>(red), 0.25F * static_cast<float>(green), 0.25F * static_cast<float>(blue));
}

double vpModelColors::agreement(const Eigen::Isometry3d &cMo, std::size_t every) const
{
  const Eigen::Isometry3f pose = cMo.cast<float>();
  const Eigen::Vector3f eye = pose.linear().transpose() * -pose.translation(); // In the object's frame.
  const float px = static_cast<float>(m_camera.get_px());
  const float py = static_cast<float>(m_camera.get_py());
  const float u0 = static_cast<float>(m_camera.get_u0());
  const float v0 = static_cast<float>(m_camera.get_v0());
  const float right = static_cast<float>(m_gray->getWidth()) - 1.F;
  const float bottom = static_cast<float>(m_gray->getHeight()) - 1.F;
  Sums sums;
  for (std::size_t i = 0; i < m_places.size(); i += every) {
    const Place &place = m_places[i];
    const Eigen::Vector3f sight = eye - place.position;
    const float facing = sight.dot(place.normal);
    const float least = leastFacing * sight.norm();
    if ((place.bothSides ? std::fabs(facing) : facing) < least) {
      continue;
    }
    const Eigen::Vector3f at = pose * place.position;
    if (!(at.z() > 0.F)) {
      continue;
    }
    const float u = px * at.x() / at.z() + u0;
    const float v = py * at.y() / at.z() + v0;
    if (u >= 0.F && v >= 0.F && u < right && v < bottom) {
      Shade model = place.shade;
      if (m_color == nullptr) {
        model[1] = model[2] = 0.F;
      }
      sums.add(model, shadeAt(static_cast<int>(u), static_cast<int>(v)), place.group);
    }
  }
  if (sums.count < static_cast<float>(fewestPlaces) / static_cast<float>(every)) {
    return 0.;
  }
  sums.centre();
  return static_cast<double>(sums.correlation());
}

END_VISP_NAMESPACE
