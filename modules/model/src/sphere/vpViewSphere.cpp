// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpViewSphere.h>

#include "sphere/vpFingerprint.h"
#include "sphere/vpIcosphere.h"
#include "sphere/vpSphereFile.h"

#include <visp3/core/vpException.h>

#include <Eigen/Geometry>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
// Of the object's diameter in the virtual camera's image, pixels. From the distance of one diameter its box still spans
// less than 231 pixels, so that it is inside the image from everywhere.
const double pixelsOfDiameter = 200.;
// The camera is never nearer to a point of the object than half a diameter.
const double nearestOfDiameter = 0.25;

void require(bool ok, const char *member, double value, const char *range)
{
  if (!ok) {
    throw vpException(vpException::badValue, "vpViewSphereOptions::%s is %g, it must be %s", member, value, range);
  }
}

const std::shared_ptr<const vpTrackedModel> &requireModel(const std::shared_ptr<const vpTrackedModel> &model)
{
  if (!model) {
    throw vpException(vpException::badValue, "A view sphere needs a model, and the pointer to it is null");
  }
  return model;
}

const vpViewSphereOptions &requireGood(const vpViewSphereOptions &options)
{
  options.check();
  return options;
}

// A fresh view sees what appears, and all of the object is before the camera and inside the image.
vpModelViewOptions withoutHistory(vpModelViewOptions options, double diameter)
{
  options.disappearAngle = options.appearAngle;
  options.nearDistance = nearestOfDiameter * diameter;
  options.farDistance = 0.;
  options.border = 0.;
  return options;
}
} // namespace

void vpViewSphereOptions::check() const
{
  require(level <= vpIcosphere::mostLevels, "level", level, "at most 4");
  require(distance > 1. && distance <= 1000., "distance", distance, "above 1 and at most 1000 diameters");
  require(points >= 1 && points <= 10000, "points", points, "1 to 10000");
  view.check();
}

vpViewSphere::vpViewSphere(const std::shared_ptr<const vpTrackedModel> &model, const vpViewSphereOptions &options,
                           std::unique_ptr<vpModelRenderer> renderer)
    : m_options(requireGood(options)), m_directions(std::make_shared<const vpIcosphere>(options.level)),
      m_renderer(std::move(renderer)),
      m_camera(pixelsOfDiameter * options.distance, pixelsOfDiameter * options.distance, 0.5 * (imageSize - 1.),
               0.5 * (imageSize - 1.)),
      m_view(requireModel(model)), m_views(size(options.level)), m_isMade(m_views.size(), 0)
{
  if (!m_renderer && !model->isConvex()) {
    throw vpException(vpException::badValue,
                      "A view sphere of a model that is not convex needs a renderer: see vpModelRenderer::create()");
  }
  m_viewOptions = withoutHistory(options.view, model->diameter());
}

// Were the directions' cells regular hexagons of equal area A, they would be sqrt(2 A / sqrt(3)) apart.
double vpViewSphere::spacing(unsigned int level)
{
  return std::sqrt(8. * M_PI / (std::sqrt(3.) * static_cast<double>(size(level))));
}

std::size_t vpViewSphere::checked(std::size_t i) const
{
  if (i >= m_views.size()) {
    throw vpException(vpException::badValue, "The view sphere has no view %zu, only %zu views", i, m_views.size());
  }
  return i;
}

const Eigen::Vector3d &vpViewSphere::directionOf(std::size_t i) const
{
  return m_directions->directions()[checked(i)];
}

vpHomogeneousMatrix vpViewSphere::poseOf(std::size_t i) const
{
  const Eigen::Vector3d &direction = directionOf(i);
  const Eigen::Vector3d up = std::fabs(direction.z()) < 0.99 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  Eigen::Matrix3d cRo;
  cRo.row(2) = -direction;
  cRo.row(0) = up.cross(direction).normalized();
  cRo.row(1) = cRo.row(2).cross(cRo.row(0));
  const double depth = m_options.distance * model().diameter();
  const Eigen::Vector3d cto = Eigen::Vector3d(0., 0., depth) - cRo * model().centre();
  vpHomogeneousMatrix cMo;
  for (unsigned int row = 0; row < 3; ++row) {
    for (unsigned int column = 0; column < 3; ++column) {
      cMo[row][column] = cRo(row, column);
    }
    cMo[row][3] = cto(row);
  }
  return cMo;
}

std::size_t vpViewSphere::nearest(const Eigen::Vector3d &fromCentre, unsigned int level) const
{
  if (level > m_options.level) {
    throw vpException(vpException::badValue, "The view sphere has levels up to %u, not %u", m_options.level, level);
  }
  return m_directions->nearest(fromCentre, level);
}

std::size_t vpViewSphere::nearest(const vpHomogeneousMatrix &cMo, unsigned int level) const
{
  const double *m = cMo.data; // Faster than its operators, which are no inline functions.
  const Eigen::Vector3d cameraInObject(-(m[0] * m[3] + m[4] * m[7] + m[8] * m[11]),
                                       -(m[1] * m[3] + m[5] * m[7] + m[9] * m[11]),
                                       -(m[2] * m[3] + m[6] * m[7] + m[10] * m[11]));
  return nearest(cameraInObject - model().centre(), level);
}

bool vpViewSphere::isMade(std::size_t i) const
{
  return m_isMade[checked(i)] != 0;
}

void vpViewSphere::make(std::size_t i)
{
  if (isMade(i)) {
    return;
  }
  m_view.compute(poseOf(i), m_camera, imageSize, imageSize, m_viewOptions, m_renderer.get());
  m_views[i] = vpSphereView(m_view.points(), m_options.points);
  m_isMade[i] = 1;
}

const vpSphereView &vpViewSphere::view(std::size_t i)
{
  make(i);
  return m_views[i];
}

std::string vpViewSphere::fileName() const
{
  std::ostringstream name;
  name << std::hex << std::setfill('0') << std::setw(16) << fingerprintOf(model(), m_options) << ".views";
  return name.str();
}

void vpViewSphere::save(const std::string &file) const
{
  vpSphereFile(file, fingerprintOf(model(), m_options)).write(m_views, m_isMade);
}

void vpViewSphere::load(const std::string &file)
{
  vpSphereFile(file, fingerprintOf(model(), m_options)).read(m_options.points, m_views, m_isMade);
}

std::size_t vpViewSphere::memory() const
{
  std::size_t bytes =
      sizeof(*this) + m_directions->memory() + m_views.capacity() * sizeof(vpSphereView) + m_isMade.capacity();
  for (const vpSphereView &view : m_views) {
    bytes += view.memory();
  }
  return bytes;
}

END_VISP_NAMESPACE
