// SPDX-License-Identifier: GPL-2.0-or-later
#include "generate/caoText.h"

#include <iomanip>
#include <sstream>

namespace bench {

std::size_t CaoText::indexOf(const Eigen::Vector3d &point)
{
  const double same = 1e-9;
  for (std::size_t i = 0; i < m_points.size(); ++i) {
    if ((m_points[i] - point).norm() < same) {
      return i;
    }
  }
  m_points.push_back(point);
  return m_points.size() - 1;
}

void CaoText::addFace(const std::vector<Eigen::Vector3d> &corners, const std::string &name)
{
  Primitive face;
  face.name = name;
  for (const Eigen::Vector3d &corner : corners) {
    face.points.push_back(indexOf(corner));
  }
  m_faces.push_back(face);
}

void CaoText::addCylinder(const Eigen::Vector3d &start, const Eigen::Vector3d &end, double radius,
                          const std::string &name)
{
  m_cylinders.push_back({{indexOf(start), indexOf(end)}, radius, name});
}

void CaoText::addCircle(const Eigen::Vector3d &centre, const Eigen::Vector3d &second, const Eigen::Vector3d &third,
                        double radius, const std::string &name)
{
  m_circles.push_back({{indexOf(centre), indexOf(second), indexOf(third)}, radius, name});
}

std::string CaoText::text() const
{
  std::ostringstream out;
  out << std::setprecision(12) << "V1\n# Metres\n" << m_points.size() << "\n";
  for (const Eigen::Vector3d &p : m_points) {
    out << p.x() << " " << p.y() << " " << p.z() << "\n";
  }
  out << "# Lines\n0\n# Faces of lines\n0\n# Faces of points\n" << m_faces.size() << "\n";
  for (const Primitive &face : m_faces) {
    out << face.points.size();
    for (const std::size_t i : face.points) {
      out << " " << i;
    }
    out << " name=" << face.name << "\n";
  }
  out << "# Cylinders\n" << m_cylinders.size() << "\n";
  for (const Primitive &cylinder : m_cylinders) {
    out << cylinder.points[0] << " " << cylinder.points[1] << " " << cylinder.radius << " name=" << cylinder.name
        << "\n";
  }
  out << "# Circles\n" << m_circles.size() << "\n";
  for (const Primitive &circle : m_circles) {
    out << circle.radius << " " << circle.points[0] << " " << circle.points[1] << " " << circle.points[2]
        << " name=" << circle.name << "\n";
  }
  return out.str();
}

} // namespace bench
