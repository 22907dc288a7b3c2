// SPDX-License-Identifier: GPL-2.0-or-later
#include "motion/vpPoseCheck.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

BEGIN_VISP_NAMESPACE

namespace {
// Of the object's diameter in the image, pixels: what is smaller shows no pose, and minimisations that diverge go on to
// distances of kilometres.
const double smallest = 2.;

std::string textOf(const char *format, double first, double second)
{
  constexpr std::size_t longest = 200;
  std::string text(longest, '\0');
  const int length = std::snprintf(text.data(), longest, format, first, second);
  text.resize(std::min(static_cast<std::size_t>(std::max(length, 0)), longest - 1));
  return text;
}
} // namespace

bool vpPoseCheck::isFinite(const vpHomogeneousMatrix &cMo)
{
  return std::all_of(cMo.data, cMo.data + 16, [](double value) { return std::isfinite(value); });
}

void vpPoseCheck::requireRigid(const vpHomogeneousMatrix &cMo)
{
  if (!isFinite(cMo)) {
    throw vpException(vpException::badValue,
                      "The initial pose is not finite (NaN or infinite values): check how it was computed");
  }
  if (!cMo.getRotationMatrix().isARotationMatrix(1e-4)) {
    throw vpException(vpException::badValue,
                      "The initial pose has no rotation in its upper left 3 x 3: check how it was computed");
  }
}

std::string vpPoseCheck::whyUnbelievable(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo,
                                         const vpCameraParameters &cam)
{
  if (!isFinite(cMo)) {
    return "the estimated pose is not finite";
  }
  const Eigen::Vector3d centre = model.centre();
  const double depth = cMo[2][0] * centre.x() + cMo[2][1] * centre.y() + cMo[2][2] * centre.z() + cMo[2][3];
  if (!(depth > -0.5 * model.diameter())) {
    return textOf("at the estimated pose the object (%g m wide) is behind the camera, at %g m", model.diameter(),
                  depth);
  }
  const double size = std::min(cam.get_px(), cam.get_py()) * model.diameter() / std::max(depth, model.diameter());
  if (size < smallest) {
    return textOf("at the estimated pose the object is %g m away and %.2g pixels wide", depth, size);
  }
  return std::string();
}

// The projected corners of the bounding box tell whether a camera can see anything of the object.
void vpPoseCheck::requireInView(const vpTrackedModel &model, const vpHomogeneousMatrix &cMo,
                                const vpCameraParameters &cam, unsigned int width, unsigned int height)
{
  unsigned int inFront = 0;
  Eigen::Array2d low = Eigen::Array2d::Constant(HUGE_VAL);
  Eigen::Array2d high = -low;
  for (unsigned int corner = 0; corner < 8; ++corner) {
    const double x = ((corner & 1U) ? model.boxMax() : model.boxMin()).x();
    const double y = ((corner & 2U) ? model.boxMax() : model.boxMin()).y();
    const double z = ((corner & 4U) ? model.boxMax() : model.boxMin()).z();
    const double cX = cMo[0][0] * x + cMo[0][1] * y + cMo[0][2] * z + cMo[0][3];
    const double cY = cMo[1][0] * x + cMo[1][1] * y + cMo[1][2] * z + cMo[1][3];
    const double cZ = cMo[2][0] * x + cMo[2][1] * y + cMo[2][2] * z + cMo[2][3];
    if (cZ > 0.) {
      ++inFront;
      const Eigen::Array2d pixel(cam.get_px() * cX / cZ + cam.get_u0(), cam.get_py() * cY / cZ + cam.get_v0());
      low = low.min(pixel);
      high = high.max(pixel);
    }
  }
  if (inFront == 0) {
    throw vpException(
        vpException::badValue,
        "At the initial pose the object is behind the camera (z = %g m): poses map object to camera, z forward",
        cMo[2][3]);
  }
  const bool outside = (high < 0.).any() || low.x() > width - 1. || low.y() > height - 1.;
  if (inFront == 8 && outside) {
    throw vpException(
        vpException::badValue,
        "At the initial pose the object (%g m wide) is outside the image: it projects to columns %.0f to %.0f, "
        "rows %.0f to %.0f of %u x %u; check pose, camera and the model's unit",
        model.diameter(), low.x(), high.x(), low.y(), high.y(), width, height);
  }
}
END_VISP_NAMESPACE
