// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpModelRenderer.h>

#include "vpCropCamera.h"
#include "vpFallbackRenderer.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/model/vpEglRenderer.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <mutex>

BEGIN_VISP_NAMESPACE

namespace {
//! Up to this size a pixel coordinate and its sub-pixel part fit the rasteriser's integers; OpenGL's usual limit too.
constexpr unsigned int maxImageSize = 16384;

//! An estimate, not measured on a GPU: up to here the CPU draws a crop of 200 pixels in less than a millisecond.
constexpr std::size_t trianglesWorthAGpu = 20000;

//! \param message Makes the text; called on failure only, as a frame must not allocate.
template <class Message> void require(bool condition, const Message &message)
{
  if (!condition) {
    throw vpException(vpException::badValue, message());
  }
}

bool isSide(unsigned int size)
{
  return size > 0 && size <= maxImageSize;
}

bool isFocalLength(double p)
{
  return std::isfinite(p) && p > 0;
}

void checkCamera(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
                 unsigned int imageHeight)
{
  require(isSide(imageWidth) && isSide(imageHeight), [=] {
    return "Rendering: the image size is " + std::to_string(imageWidth) + " x " + std::to_string(imageHeight) +
           ", give sides from 1 to " + std::to_string(maxImageSize);
  });
  require(isFocalLength(cam.get_px()) && isFocalLength(cam.get_py()), [&cam] {
    return "Rendering: the camera has px = " + std::to_string(cam.get_px()) +
           " and py = " + std::to_string(cam.get_py()) + ", give focal lengths in pixels, > 0";
  });
  require(std::isfinite(cam.get_u0()) && std::isfinite(cam.get_v0()), [&cam] {
    return "Rendering: the camera has u0 = " + std::to_string(cam.get_u0()) +
           " and v0 = " + std::to_string(cam.get_v0()) + ", give a finite principal point";
  });
  require(vpToPoseMatrix(cMo).allFinite(), [] { return "Rendering: the pose cMo has a value that is not finite"; });
}

//! A range of image coordinates along one axis, pixels.
struct Range
{
  double first = std::numeric_limits<double>::infinity();
  double last = -std::numeric_limits<double>::infinity();

  void include(double x)
  {
    first = std::min(first, x);
    last = std::max(last, x);
  }

  //! Grown by the margin and cut to an image of \e size pixels.
  Range inside(double margin, unsigned int size) const
  {
    Range range;
    range.first = std::max(first - margin, -0.5);
    range.last = std::min(last + margin, size - 0.5);
    return range;
  }

  bool empty() const { return !(first <= last); }
};

struct Extent
{
  Range u;
  Range v;
};

//! Where the model's box is seen; all of the plane where it reaches behind the near plane, empty where it is all there.
Extent projectBox(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                  double nearDistance)
{
  const vpPoseMatrix pose = vpToPoseMatrix(cMo);
  Extent extent;
  int behind = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d position((corner & 1) ? model.boxMax().x() : model.boxMin().x(),
                                   (corner & 2) ? model.boxMax().y() : model.boxMin().y(),
                                   (corner & 4) ? model.boxMax().z() : model.boxMin().z());
    const Eigen::Vector3d point = vpTransform(pose, position);
    if (point.z() < nearDistance) {
      ++behind;
    } else {
      extent.u.include(cam.get_u0() + cam.get_px() * point.x() / point.z());
      extent.v.include(cam.get_v0() + cam.get_py() * point.y() / point.z());
    }
  }
  if (behind > 0 && behind < 8) {
    extent.u.first = extent.v.first = -std::numeric_limits<double>::infinity();
    extent.u.last = extent.v.last = std::numeric_limits<double>::infinity();
  }
  return extent;
}

//! The pixels of the scaled image that a range touches.
void placeAxis(const Range &range, double scale, unsigned int imageSize, int &first, int &count)
{
  const int scaledSize = std::max(1, static_cast<int>(imageSize * scale + 0.5));
  const auto pixel = [&](double x) {
    return std::clamp(static_cast<int>(std::floor((x + 0.5) * scale)), 0, scaledSize - 1);
  };
  first = pixel(range.first);
  count = pixel(range.last) - first + 1;
}

std::unique_ptr<vpModelRenderer> createEgl(const std::shared_ptr<const vpTrackedModel> &model,
                                           vpModelRenderer::Preference preference)
{
  try {
    auto renderer = std::make_unique<vpEglRenderer>(model);
    if (preference == vpModelRenderer::EGL || !renderer->isSoftware()) {
      return std::make_unique<vpFallbackRenderer>(std::move(renderer), model);
    }
  } catch (const vpException &e) {
    static std::once_flag told;
    std::call_once(told, [&e] { std::cerr << "Rendering on the CPU: " << e.getStringMessage() << std::endl; });
  }
  return nullptr;
}
} // namespace

void vpRenderOptions::check() const
{
  require((channels & ~static_cast<unsigned int>(DEPTH | NORMAL | FACE | COLOR)) == 0, [this] {
    return "vpRenderOptions::channels is " + std::to_string(channels) +
           ", give values of vpRenderOptions::Channel or-ed";
  });
  require(scale > 0 && scale <= 1, [this] {
    return "vpRenderOptions::scale is " + std::to_string(scale) + ", give a value in (0, 1] rendered pixels per pixel";
  });
  require(std::isfinite(margin) && margin >= 0,
          [this] { return "vpRenderOptions::margin is " + std::to_string(margin) + ", give a number of pixels >= 0"; });
  require(std::isfinite(nearDistance) && nearDistance > 0, [this] {
    return "vpRenderOptions::nearDistance is " + std::to_string(nearDistance) + ", give a distance in metres > 0";
  });
}

int vpRenderedView::index(double u, double v) const
{
  const double column = std::floor((u + 0.5) * scale) - left;
  const double row = std::floor((v + 0.5) * scale) - top;
  if (!(column >= 0 && column < width && row >= 0 && row < height)) {
    return -1;
  }
  return static_cast<int>(row) * width + static_cast<int>(column);
}

std::unique_ptr<vpModelRenderer> vpModelRenderer::create(const std::shared_ptr<const vpTrackedModel> &model,
                                                         Preference preference)
{
  require(model != nullptr, [] { return "vpModelRenderer::create() was given no model"; });
  const bool large = model->triangles().size() > trianglesWorthAGpu;
  std::unique_ptr<vpModelRenderer> renderer;
  if (preference == EGL || (preference == AUTOMATIC && large)) {
    renderer = createEgl(model, preference);
  }
  return renderer ? std::move(renderer) : std::make_unique<vpCpuRenderer>(model);
}

void vpModelRenderer::placeCrop(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo,
                                const vpCameraParameters &cam, unsigned int imageWidth, unsigned int imageHeight,
                                const vpRenderOptions &options, vpRenderedView &view)
{
  options.check();
  checkCamera(cMo, cam, imageWidth, imageHeight);
  const Extent extent = projectBox(model, cMo, cam, options.nearDistance);
  const Range u = extent.u.inside(options.margin, imageWidth);
  const Range v = extent.v.inside(options.margin, imageHeight);
  view.left = view.top = view.width = view.height = 0;
  view.scale = options.scale;
  if (u.empty() || v.empty()) {
    return;
  }
  for (;;) {
    placeAxis(u, view.scale, imageWidth, view.left, view.width);
    placeAxis(v, view.scale, imageHeight, view.top, view.height);
    const int side = std::max(view.width, view.height);
    if (options.maxSize == 0 || side <= static_cast<int>(std::min(options.maxSize, maxImageSize))) {
      return;
    }
    // A range can touch one pixel more than its length: hence the 1, without which this might not end.
    view.scale *= options.maxSize / (side + 1.);
  }
}

END_VISP_NAMESPACE
