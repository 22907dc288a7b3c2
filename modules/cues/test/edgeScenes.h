// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef edgeScenes_h
#define edgeScenes_h

#include <visp3/cues/vpEdgeCue.h>
#include <visp3/cues/vpFrameSource.h>
#include <visp3/model/vpTrackedModelBuilder.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

/*!
  \file edgeScenes.h
  Images whose edges are known exactly, and models whose lines lie where a test wants them in the image.
*/

BEGIN_VISP_NAMESPACE
namespace edgeScenes {

constexpr unsigned int width = 160;
constexpr unsigned int height = 120;
constexpr double focal = 400.;

inline vpCameraParameters makeCamera()
{
  return vpCameraParameters(focal, focal, 80., 60.);
}

//! A straight line of the image.
struct Line
{
  Eigen::Vector2d through; //!< Pixels.
  double angle = 0.;       //!< Of its direction, from u towards v, radians.

  Eigen::Vector2d direction() const { return {std::cos(angle), std::sin(angle)}; }
  Eigen::Vector2d normal() const { return {-std::sin(angle), std::cos(angle)}; }
  //! Signed distance, positive on the side of normal().
  double distance(const Eigen::Vector2d &pixel) const { return normal().dot(pixel - through); }
  //! The line moved along its normal, pixels.
  Line moved(double by) const { return {through + by * normal(), angle}; }
};

//! A pixel's area is averaged over parts x parts places.
constexpr int parts = 8;

//! Brightness at \e distance from a step from 0 to 1 behind a lens that blurs by \e sigma pixels.
inline double blurredStep(double distance, double sigma)
{
  if (sigma > 0.) {
    return 0.5 * (1. + std::erf(distance / (std::sqrt(2.) * sigma)));
  }
  // As wide as the parts that draw() averages, so that a step between two of them counts by its share.
  return std::min(std::max(0.5 + parts * distance, 0.), 1.);
}

/*!
  An image of \e level(pixel), a function of Eigen::Vector2d, averaged over each pixel's area as a sensor does it.
*/
template <typename Level>
vpImage<unsigned char> draw(const Level &level, unsigned int imageWidth = width, unsigned int imageHeight = height)
{
  vpImage<unsigned char> I(imageHeight, imageWidth);
  for (unsigned int i = 0; i < imageHeight; ++i) {
    for (unsigned int j = 0; j < imageWidth; ++j) {
      double sum = 0.;
      for (int k = 0; k < parts * parts; ++k) {
        const double du = (k % parts + 0.5) / parts - 0.5;
        const double dv = (static_cast<int>(k / parts) + 0.5) / parts - 0.5;
        sum += level(Eigen::Vector2d(j + du, i + dv));
      }
      I[i][j] = static_cast<unsigned char>(std::lround(std::min(std::max(sum / (parts * parts), 0.), 255.)));
    }
  }
  return I;
}

//! An image that is \e contrast gray levels brighter on the side of the line's normal.
inline vpImage<unsigned char> drawStep(const Line &line, double contrast, double sigma = 0.)
{
  return draw(
      [&](const Eigen::Vector2d &pixel) { return 128. + contrast * (blurredStep(line.distance(pixel), sigma) - 0.5); });
}

inline void addNoise(vpImage<unsigned char> &I, double sigma, unsigned int seed)
{
  std::mt19937 random(seed);
  // Twelve uniform numbers: nearly Gaussian, and the same with every standard library.
  const auto gaussian = [&random]() {
    double sum = -6.;
    for (int i = 0; i < 12; ++i) {
      sum += static_cast<double>(random()) / 4294967296.;
    }
    return sum;
  };
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    const double level = I.bitmap[i] + sigma * gaussian();
    I.bitmap[i] = static_cast<unsigned char>(std::lround(std::min(std::max(level, 0.), 255.)));
  }
}

//! Where a pixel's line of sight meets the plane z = \e depth of the camera frame.
inline Eigen::Vector3d backProject(const Eigen::Vector2d &pixel, double depth = 1.)
{
  const vpCameraParameters cam = makeCamera();
  return {depth * (pixel.x() - cam.get_u0()) / cam.get_px(), depth * (pixel.y() - cam.get_v0()) / cam.get_py(), depth};
}

/*!
  The view of a model that consists of straight lines, at the pose where the object's frame is the camera's: each line
  is in the plane z = 1 and reaches \e halfLength pixels to both sides of Line::through.
*/
inline vpModelView viewOf(const std::vector<Line> &lines, double halfLength = 40.,
                          const vpModelViewOptions &options = vpModelViewOptions())
{
  vpTrackedModelBuilder builder;
  for (const Line &line : lines) {
    builder.addLine(backProject(line.through - halfLength * line.direction()),
                    backProject(line.through + halfLength * line.direction()));
  }
  vpModelView view(std::make_shared<const vpTrackedModel>(builder.build("lines")));
  view.compute(vpHomogeneousMatrix(), makeCamera(), width, height, options, nullptr);
  return view;
}

//! A box around the origin. \param half Half the lengths of its sides, metres.
inline void addBox(vpTrackedModelBuilder &builder, const Eigen::Vector3d &half)
{
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1., 1.}) {
      const Eigen::Vector3d out = sign * Eigen::Vector3d::Unit(axis);
      const Eigen::Vector3d right = Eigen::Vector3d::Unit((axis + 1) % 3);
      const Eigen::Vector3d up = out.cross(right);
      builder.addFace({half.cwiseProduct(out - right - up), half.cwiseProduct(out + right - up),
                       half.cwiseProduct(out + right + up), half.cwiseProduct(out - right + up)});
    }
  }
}

//! Where along its normal a control point meets a line of the image, pixels.
inline double offsetTo(const Line &line, const vpControlPoint &point)
{
  return -line.distance(point.pixel) / line.normal().dot(point.normal);
}

inline std::size_t found(const vpEdgeCue &cue)
{
  return static_cast<std::size_t>(
      std::count_if(cue.matches().begin(), cue.matches().end(), [](const vpEdgeCue::Match &m) { return m.count > 0; }));
}

inline std::size_t inState(const vpEdgeCue &cue, vpFeatureState state)
{
  return static_cast<std::size_t>(std::count_if(cue.matches().begin(), cue.matches().end(),
                                                [state](const vpEdgeCue::Match &m) { return m.state == state; }));
}

//! Matches \e view in \e I with the camera of makeCamera().
inline void match(vpEdgeCue &cue, const vpImage<unsigned char> &I, const vpModelView &view,
                  const vpImage<bool> *mask = nullptr)
{
  vpFrameSource source;
  cue.match(source.frame(I, makeCamera(), mask), view);
}

//! Has the cue learn from the last match, every row of it trusted.
inline void learn(vpEdgeCue &cue, const vpHomogeneousMatrix &cMo = vpHomogeneousMatrix())
{
  cue.updateReference(cMo, std::vector<double>(found(cue), 1.));
}

//! Mean of what a function tells of the matches at a column; NaN where fewer than 6 are there.
template <typename Value> double meanAt(const vpEdgeCue &cue, double u, const Value &value)
{
  double sum = 0.;
  int count = 0;
  for (const vpEdgeCue::Match &match : cue.matches()) {
    if (std::fabs(match.point.pixel.x() - u) < 0.5) {
      sum += value(match);
      ++count;
    }
  }
  return count > 5 ? sum / count : std::nan("");
}

} // namespace edgeScenes
END_VISP_NAMESPACE
#endif
