// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef searchScenes_h
#define searchScenes_h

#include "colorScenes.h"

#include <modelShapes.h>

#include <visp3/cues/vpColorOddsMap.h>
#include <visp3/cues/vpOrientedDistanceMap.h>
#include <visp3/model/vpViewSphere.h>
#include <visp3/se3/vpPoseExponential.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <string>

/*! \file searchScenes.h A box of one colour before a background of another one, and what a search sees of it. */

BEGIN_VISP_NAMESPACE
namespace searchScenes {

//! Three sides of the box are well in view.
inline vpHomogeneousMatrix truePose()
{
  return vpHomogeneousMatrix(0.01, -0.01, 0.6, 0.9, 0.5, -0.2);
}

//! Writes the box as a mesh. \param size Lengths of its sides, metres. \return name
inline std::string writeBox(const Eigen::Vector3d &size, const std::string &name)
{
  std::ofstream file(name);
  file.precision(std::numeric_limits<double>::max_digits10);
  int count = 0;
  for (const auto &side : modelShapes::boxPolygons(size)) {
    for (const Eigen::Vector3d &corner : side) {
      file << "v " << corner.x() << " " << corner.y() << " " << corner.z() << "\n";
    }
    file << "f " << count + 1 << " " << count + 2 << " " << count + 3 << "\nf " << count + 1 << " " << count + 3 << " "
         << count + 4 << "\n";
    count += 4;
  }
  return name;
}

//! In the middle of the histograms' steps, so that noise does not change them.
inline colorScenes::Paint plainPaint()
{
  colorScenes::Paint paint;
  paint.object = [](const Eigen::Vector3d &) { return colorScenes::Color(200., 56., 40.); };
  paint.background = [](double, double) { return colorScenes::Color(72., 120., 88.); };
  return paint;
}

//! The histograms of an object's and a background's colours, about as the scenes draw them.
inline vpColorHistograms learnt(const colorScenes::Paint &paint)
{
  vpColorHistograms histograms;
  const auto count = [&](const colorScenes::Color &color, vpColorHistograms::Side side) {
    for (int shift = -8; shift < 8; ++shift) {
      const auto level = [&](int c) { return static_cast<std::uint32_t>(color[c] + shift); };
      histograms.count(level(0) | level(1) << 8U | level(2) << 16U, side);
    }
  };
  count(paint.object(Eigen::Vector3d::Zero()), vpColorHistograms::OBJECT);
  count(paint.background(0., 0.), vpColorHistograms::BACKGROUND);
  histograms.learn(1.);
  return histograms;
}

//! The maps of an image of the box at the true pose.
struct BoxScene
{
  explicit BoxScene(const colorScenes::Paint &paint = plainPaint(), const vpHomogeneousMatrix &cMo = truePose())
      : image(colorScenes::Scene(*model).draw(cMo, paint))
  {
    const vpCueFrame frame = source.frame(image, camera, nullptr);
    const vpImageRegion all(0, 0, static_cast<int>(width), static_cast<int>(height));
    odds.compute(frame, learnt(plainPaint()), all);
    edges.compute(frame, all);
  }

  static constexpr unsigned int width = colorScenes::width;
  static constexpr unsigned int height = colorScenes::height;
  vpCameraParameters camera = colorScenes::makeCamera();
  std::shared_ptr<const vpTrackedModel> model = std::make_shared<const vpTrackedModel>(colorScenes::makeBox());
  vpViewSphere sphere{model, vpViewSphereOptions(), std::make_unique<vpCpuRenderer>(model)};
  vpImage<vpRGBa> image;
  vpFrameSource source;
  vpColorOddsMap odds;
  vpOrientedDistanceMap edges;
};

//! How far two poses of the box are apart.
struct Difference
{
  double degrees;
  double diameters; //!< Between its middles.
};

inline Difference differenceOf(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b, const vpTrackedModel &model)
{
  const Eigen::Isometry3d first = vpPoseExponential::toEigen(a);
  const Eigen::Isometry3d second = vpPoseExponential::toEigen(b);
  const double angle = Eigen::AngleAxisd(first.linear().transpose() * second.linear()).angle();
  return {angle * 180. / M_PI, (first * model.centre() - second * model.centre()).norm() / model.diameter()};
}

//! Turned about its middle by an angle, and moved.
inline vpHomogeneousMatrix displaced(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &axis, double degrees,
                                     const Eigen::Vector3d &shift)
{
  Eigen::Isometry3d pose = vpPoseExponential::toEigen(cMo); // The box's middle is the origin.
  pose.linear() = pose.linear() * Eigen::AngleAxisd(degrees * M_PI / 180., axis.normalized()).toRotationMatrix();
  pose.translation() += shift;
  return vpPoseExponential::fromEigen(pose);
}

//! Axes in several directions.
inline std::array<Eigen::Vector3d, 6> axes()
{
  return {{Eigen::Vector3d(1., 0., 0.), Eigen::Vector3d(0., 1., 0.), Eigen::Vector3d(0., 0., 1.),
           Eigen::Vector3d(-1., 1., 0.3), Eigen::Vector3d(0.5, -1., 1.), Eigen::Vector3d(-1., -1., -1.)}};
}

} // namespace searchScenes
END_VISP_NAMESPACE
#endif
