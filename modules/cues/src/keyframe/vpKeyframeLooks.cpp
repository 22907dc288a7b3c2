// SPDX-License-Identifier: GPL-2.0-or-later
#include "keyframe/vpKeyframeLooks.h"

BEGIN_VISP_NAMESPACE

namespace {
// Blur and turns in between leave less of a patch than what a point's track asks for.
const vpSurfacePatch::Limits sameLook = {3.F, 0.6F};

cv::Mat pixelsOf(const vpCueFrame &frame)
{
  const vpImage<unsigned char> &I = frame.gray();
  return cv::Mat(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8U, I.bitmap);
}
} // namespace

void vpKeyframeLooks::add(const vpCueFrame &frame, const vpSurfaceElement &surface, const cv::Point2f &place)
{
  m_looks.push_back({surface, vpSurfacePatch()});
  m_looks.back().patch.take(pixelsOf(frame), place);
}

bool vpKeyframeLooks::isSeenAgain(std::size_t number, const vpCueFrame &frame, const vpPointCamera &camera) const
{
  const Look &look = m_looks[number];
  const Eigen::Vector3d at = camera.toCamera(look.surface.position);
  if (!(at.z() > 0.) || !look.surface.isFacing(camera, at)) {
    return false;
  }
  const Eigen::Matrix2d distortion = camera.derivative(at) * camera.cRo * look.surface.across;
  const Eigen::Vector2d expected = camera.project(at);
  cv::Point2f place(static_cast<float>(expected.x()), static_cast<float>(expected.y()));
  return look.patch.align(pixelsOf(frame), distortion, sameLook, place) &&
         !frame.isMasked(static_cast<double>(place.x), static_cast<double>(place.y));
}

END_VISP_NAMESPACE
