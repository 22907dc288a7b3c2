// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "model/vpCaoFile.h"

#include <visp3/mbt/vpMbtDistanceLine.h>

#include <array>
#include <map>
#include <utility>

BEGIN_VISP_NAMESPACE

namespace {
/*!
  The lines of the projection error by their ends. vpMbTracker compares every new line with all others, which takes
  minutes for a model of some ten thousand faces.
*/
struct KnownLines
{
  using Ends = std::array<double, 6>;

  explicit KnownLines(const std::vector<vpMbtDistanceLine *> &lines)
  {
    for (vpMbtDistanceLine *line : lines) {
      at.emplace(endsOf(*line->p1, *line->p2), line);
    }
  }

  static Ends endsOf(const vpPoint &a, const vpPoint &b)
  {
    const std::array<double, 3> first = {{a.get_oX(), a.get_oY(), a.get_oZ()}};
    const std::array<double, 3> second = {{b.get_oX(), b.get_oY(), b.get_oZ()}};
    const auto &low = first < second ? first : second;
    const auto &high = first < second ? second : first;
    return {{low[0], low[1], low[2], high[0], high[1], high[2]}};
  }

  std::map<Ends, vpMbtDistanceLine *> at;
};
} // namespace

//! What vpMbTracker keeps of a .cao file: polygons with their level of detail, and the lines of its projection error.
class vpMbMultiCueTracker::CaoPrimitives
{
public:
  //! \param face Number of the first face, and of the one after the last.
  CaoPrimitives(vpMbMultiCueTracker &tracker, int &face)
      : m_tracker(tracker), m_face(face), m_lines(tracker.m_projectionErrorLines)
  {
  }

  void add(const vpCaoShape &shape);

private:
  void addFace(const vpCaoShape &shape);
  void addLines(const vpMbtPolygon &polygon, bool ofLines);
  void addCylinder(const vpCaoShape &shape);
  void addCircle(const vpCaoShape &shape);
  bool usesLod(const vpCaoShape &shape) const;
  double smallestLine(const vpCaoShape &shape) const;
  double smallestArea(const vpCaoShape &shape) const;

  vpMbMultiCueTracker &m_tracker;
  int &m_face;
  KnownLines m_lines;
};

void vpMbMultiCueTracker::loadCAOModel(const std::string &modelFile, std::vector<std::string> &, int &startIdFace, bool,
                                       bool, const vpHomogeneousMatrix &odTo)
{
  CaoPrimitives primitives(*this, startIdFace);
  for (const vpCaoShape &shape : vpCaoFile::read(modelFile, odTo).shapes) {
    primitives.add(shape);
  }
}

void vpMbMultiCueTracker::CaoPrimitives::add(const vpCaoShape &shape)
{
  switch (shape.kind) {
  case vpCaoShape::FACE:
  case vpCaoShape::FACE_OF_LINES:
    addFace(shape);
    break;
  case vpCaoShape::CYLINDER:
    addCylinder(shape);
    break;
  case vpCaoShape::CIRCLE:
    addCircle(shape);
    break;
  }
}

bool vpMbMultiCueTracker::CaoPrimitives::usesLod(const vpCaoShape &shape) const
{
  return shape.useLod.value_or(!m_tracker.applyLodSettingInConfig && m_tracker.useLodGeneral);
}

double vpMbMultiCueTracker::CaoPrimitives::smallestLine(const vpCaoShape &shape) const
{
  return shape.minLineLength.value_or(m_tracker.applyLodSettingInConfig ? 50.
                                                                        : m_tracker.minLineLengthThresholdGeneral);
}

double vpMbMultiCueTracker::CaoPrimitives::smallestArea(const vpCaoShape &shape) const
{
  return shape.minPolygonArea.value_or(m_tracker.applyLodSettingInConfig ? 2500.
                                                                         : m_tracker.minPolygonAreaThresholdGeneral);
}

void vpMbMultiCueTracker::CaoPrimitives::addFace(const vpCaoShape &shape)
{
  const double area = shape.isLine ? m_tracker.minPolygonAreaThresholdGeneral : smallestArea(shape);
  const double length = shape.isLine ? smallestLine(shape) : m_tracker.minLineLengthThresholdGeneral;
  m_tracker.addPolygon(shape.points, m_face, shape.name, usesLod(shape), area, length);
  m_tracker.addProjectionErrorPolygon(shape.points, m_face++, shape.name, usesLod(shape), area, length);
  addLines(*m_tracker.m_projectionErrorFaces.getPolygon().back(), shape.kind == vpCaoShape::FACE_OF_LINES);
}

// As initProjectionErrorFaceFromCorners() and initProjectionErrorFaceFromLines(), but
// m_tracker.addProjectionErrorLine() sees nothing but the line that may be the same.
void vpMbMultiCueTracker::CaoPrimitives::addLines(const vpMbtPolygon &polygon, bool ofLines)
{
  const unsigned int corners = polygon.getNbPoint();
  for (unsigned int j = 0; j < (ofLines ? corners - 1 : corners); ++j) {
    vpPoint &start = polygon.p[j];
    vpPoint &end = polygon.p[(j + 1) % corners];
    vpMbtDistanceLine *&known = m_lines.at[KnownLines::endsOf(start, end)];
    std::vector<vpMbtDistanceLine *> others(known == nullptr ? 0 : 1, known);
    others.swap(m_tracker.m_projectionErrorLines);
    m_tracker.addProjectionErrorLine(start, end, polygon.getIndex(), polygon.getName());
    others.swap(m_tracker.m_projectionErrorLines);
    if (known == nullptr) {
      known = others.back();
      known->setIndex(static_cast<unsigned int>(m_tracker.m_projectionErrorLines.size()));
      m_tracker.m_projectionErrorLines.push_back(known);
    }
  }
}

void vpMbMultiCueTracker::CaoPrimitives::addCylinder(const vpCaoShape &shape)
{
  const vpPoint &start = shape.points[0];
  const vpPoint &end = shape.points[1];
  const int axis = m_face;
  m_tracker.addPolygon(start, end, axis, shape.name, usesLod(shape), smallestLine(shape));
  m_tracker.addProjectionErrorPolygon(start, end, m_face++, shape.name, usesLod(shape), smallestLine(shape));
  std::vector<std::vector<vpPoint>> box;
  m_tracker.createCylinderBBox(start, end, shape.radius, box);
  m_tracker.addPolygon(box, m_face, shape.name, usesLod(shape), smallestLine(shape));
  m_tracker.addProjectionErrorPolygon(box, m_face, shape.name, usesLod(shape), smallestLine(shape));
  m_tracker.initProjectionErrorCylinder(start, end, shape.radius, axis, shape.name);
  m_face += 4;
}

void vpMbMultiCueTracker::CaoPrimitives::addCircle(const vpCaoShape &shape)
{
  const std::vector<vpPoint> &points = shape.points;
  m_tracker.addPolygon(points[0], points[1], points[2], shape.radius, m_face, shape.name, usesLod(shape),
                       smallestArea(shape));
  m_tracker.addProjectionErrorPolygon(points[0], points[1], points[2], shape.radius, m_face, shape.name, usesLod(shape),
                                      smallestArea(shape));
  m_tracker.initProjectionErrorCircle(points[0], points[1], points[2], shape.radius, m_face++, shape.name);
}

END_VISP_NAMESPACE
