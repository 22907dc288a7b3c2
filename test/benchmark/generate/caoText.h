// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchCaoText_h
#define benchCaoText_h

#include <Eigen/Core>

#include <string>
#include <vector>

namespace bench {

//! Collects what a model file of ViSP (.cao, V1) holds and writes it.
class CaoText
{
public:
  //! \param corners Counter-clockwise seen from outside, metres.
  void addFace(const std::vector<Eigen::Vector3d> &corners, const std::string &name);
  void addCylinder(const Eigen::Vector3d &start, const Eigen::Vector3d &end, double radius, const std::string &name);
  //! \param second, third Two more points of its plane, counter-clockwise about the side that it is seen from.
  void addCircle(const Eigen::Vector3d &centre, const Eigen::Vector3d &second, const Eigen::Vector3d &third,
                 double radius, const std::string &name);
  std::string text() const;

private:
  std::size_t indexOf(const Eigen::Vector3d &point);

  struct Primitive
  {
    std::vector<std::size_t> points;
    double radius = 0.;
    std::string name;
  };
  std::vector<Eigen::Vector3d> m_points;
  std::vector<Primitive> m_faces;
  std::vector<Primitive> m_cylinders;
  std::vector<Primitive> m_circles;
};

} // namespace bench
#endif
