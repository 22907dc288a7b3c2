// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/model/vpTrackedModelBuilder.h>

#include "modelErrors.h"
#include "modelParts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

BEGIN_VISP_NAMESPACE
using namespace vpMeshDetail;

namespace {
// Nobody reads more, and a file may give rise to one for each of its lines.
constexpr std::size_t mostWarnings = 100;

void checkRange(const char *name, double value, double lowest, double highest, bool lowestIsAllowed)
{
  if (!((lowestIsAllowed ? value >= lowest : value > lowest) && value <= highest)) {
    std::ostringstream text;
    text << "vpModelOptions::" << name << " is " << value << ": it has to be "
         << (lowestIsAllowed ? "at least " : "more than ") << lowest << " and at most " << highest;
    refuse(text.str());
  }
}

void checkRadius(double radius, const std::string &what)
{
  if (!(radius > 0.) || !std::isfinite(radius)) {
    std::ostringstream text;
    text << "the " << what << " has a radius of " << radius << ": it has to be more than 0 m";
    refuse(text.str());
  }
}

} // namespace

void vpModelOptions::check() const
{
  constexpr double any = std::numeric_limits<double>::max();
  checkRange("unit", unit, 0., any, false);
  checkRange("creaseAngle", creaseAngle, 0., 180. - 1e-9, false);
  checkRange("weldTolerance", weldTolerance, 0., 0.01, true);
  checkRange("minSize", minSize, 0., any, false);
  checkRange("maxSize", maxSize, minSize, any, false);
}

vpTrackedModelBuilder::vpTrackedModelBuilder(const vpModelOptions &options) : m_options(options)
{
  options.check();
}

void vpTrackedModelBuilder::addFace(const std::vector<Eigen::Vector3d> &corners, const std::string &name, int polygon,
                                    bool closed)
{
  if (corners.size() < 3) {
    refuse("the " + describe("polygon", name, polygon) + " has less than 3 corners");
  }
  m_faces.push_back(Primitive{corners, 0., name, polygon, closed});
}

void vpTrackedModelBuilder::addLine(const Eigen::Vector3d &start, const Eigen::Vector3d &end, const std::string &name,
                                    int polygon)
{
  m_lines.push_back(Primitive{{start, end}, 0., name, polygon, false});
}

void vpTrackedModelBuilder::addCylinder(const Eigen::Vector3d &start, const Eigen::Vector3d &end, double radius,
                                        const std::string &name, int polygon)
{
  checkRadius(radius, describe("cylinder", name, polygon));
  m_cylinders.push_back(Primitive{{start, end}, radius, name, polygon, true});
}

void vpTrackedModelBuilder::addCircle(const Eigen::Vector3d &centre, const Eigen::Vector3d &second,
                                      const Eigen::Vector3d &third, double radius, const std::string &name, int polygon)
{
  checkRadius(radius, describe("circle", name, polygon));
  m_circles.push_back(Primitive{{centre, second, third}, radius, name, polygon, true});
}

void vpTrackedModelBuilder::addTriangle(const std::array<Corner, 3> &corners, int image)
{
  if (image < -1 || image > lastIndex(m_appearance.images)) {
    refuse("a triangle refers to image " + std::to_string(image) + " of " + std::to_string(m_appearance.images.size()) +
           ": give an index that addImage() returned, or -1");
  }
  const Corner plain;
  const bool coloured =
      std::any_of(corners.begin(), corners.end(), [&](const Corner &corner) { return corner.color != plain.color; });
  if (coloured && m_appearance.color.empty()) {
    m_appearance.color.assign(m_triangles.size(), {{plain.color, plain.color, plain.color}});
  }
  if (coloured || !m_appearance.color.empty()) {
    m_appearance.color.push_back({{corners[0].color, corners[1].color, corners[2].color}});
  }
  if (image >= 0 && m_appearance.image.empty()) {
    m_appearance.image.assign(m_triangles.size(), -1);
    m_appearance.texture.assign(m_triangles.size(), {{plain.texture, plain.texture, plain.texture}});
  }
  if (image >= 0 || !m_appearance.image.empty()) {
    m_appearance.image.push_back(image);
    m_appearance.texture.push_back({{corners[0].texture, corners[1].texture, corners[2].texture}});
  }
  m_triangles.push_back({{corners[0].position, corners[1].position, corners[2].position}});
}

int vpTrackedModelBuilder::addImage(const vpImage<vpRGBa> &image)
{
  if (image.getSize() == 0) {
    ++m_missingImages;
    return -1;
  }
  m_appearance.images.push_back(image);
  return lastIndex(m_appearance.images);
}

void vpTrackedModelBuilder::addWarning(const std::string &text)
{
  if (m_warnings.size() <= mostWarnings && std::find(m_warnings.begin(), m_warnings.end(), text) == m_warnings.end()) {
    m_warnings.push_back(m_warnings.size() < mostWarnings ? text : "there are more warnings, which are left out");
  }
}
END_VISP_NAMESPACE
