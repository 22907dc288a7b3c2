// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include "model/vpCaoFile.h"

#include <visp3/mbt/vpMbtDistanceLine.h>

#include <array>
#include <map>
#include <utility>

BEGIN_VISP_NAMESPACE

/*!
  The lines of the projection error by their ends. vpMbTracker compares every new line with all others, which takes
  minutes for a model of some ten thousand faces.
*/
struct vpMbMultiCueTracker::KnownLines
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

// What vpMbTracker keeps of a .cao file: polygons with their level of detail, and the lines of its projection error.
void vpMbMultiCueTracker::loadCAOModel(const std::string &modelFile, std::vector<std::string> &, int &startIdFace, bool,
                                       bool, const vpHomogeneousMatrix &odTo)
{
  KnownLines lines(m_projectionErrorLines);
  for (const vpCaoShape &shape : vpCaoFile::read(modelFile, odTo).shapes) {
    switch (shape.kind) {
    case vpCaoShape::FACE:
    case vpCaoShape::FACE_OF_LINES:
      addCaoFace(shape, startIdFace, lines);
      break;
    case vpCaoShape::CYLINDER:
      addCaoCylinder(shape, startIdFace);
      break;
    case vpCaoShape::CIRCLE:
      addCaoCircle(shape, startIdFace);
      break;
    }
  }
}

bool vpMbMultiCueTracker::usesLod(const vpCaoShape &shape) const
{
  return shape.useLod.value_or(!applyLodSettingInConfig && useLodGeneral);
}

double vpMbMultiCueTracker::smallestLine(const vpCaoShape &shape) const
{
  return shape.minLineLength.value_or(applyLodSettingInConfig ? 50. : minLineLengthThresholdGeneral);
}

double vpMbMultiCueTracker::smallestArea(const vpCaoShape &shape) const
{
  return shape.minPolygonArea.value_or(applyLodSettingInConfig ? 2500. : minPolygonAreaThresholdGeneral);
}

void vpMbMultiCueTracker::addCaoFace(const vpCaoShape &shape, int &face, KnownLines &lines)
{
  const double area = shape.isLine ? minPolygonAreaThresholdGeneral : smallestArea(shape);
  const double length = shape.isLine ? smallestLine(shape) : minLineLengthThresholdGeneral;
  addPolygon(shape.points, face, shape.name, usesLod(shape), area, length);
  addProjectionErrorPolygon(shape.points, face++, shape.name, usesLod(shape), area, length);
  addProjectionErrorLines(*m_projectionErrorFaces.getPolygon().back(), shape.kind == vpCaoShape::FACE_OF_LINES, lines);
}

// As initProjectionErrorFaceFromCorners() and initProjectionErrorFaceFromLines(), but addProjectionErrorLine() sees
// nothing but the line that may be the same.
void vpMbMultiCueTracker::addProjectionErrorLines(const vpMbtPolygon &polygon, bool ofLines, KnownLines &lines)
{
  const unsigned int corners = polygon.getNbPoint();
  for (unsigned int j = 0; j < (ofLines ? corners - 1 : corners); ++j) {
    vpPoint &start = polygon.p[j];
    vpPoint &end = polygon.p[(j + 1) % corners];
    vpMbtDistanceLine *&known = lines.at[KnownLines::endsOf(start, end)];
    std::vector<vpMbtDistanceLine *> others(known == nullptr ? 0 : 1, known);
    others.swap(m_projectionErrorLines);
    addProjectionErrorLine(start, end, polygon.getIndex(), polygon.getName());
    others.swap(m_projectionErrorLines);
    if (known == nullptr) {
      known = others.back();
      known->setIndex(static_cast<unsigned int>(m_projectionErrorLines.size()));
      m_projectionErrorLines.push_back(known);
    }
  }
}

void vpMbMultiCueTracker::addCaoCylinder(const vpCaoShape &shape, int &face)
{
  const vpPoint &start = shape.points[0];
  const vpPoint &end = shape.points[1];
  const int axis = face;
  addPolygon(start, end, axis, shape.name, usesLod(shape), smallestLine(shape));
  addProjectionErrorPolygon(start, end, face++, shape.name, usesLod(shape), smallestLine(shape));
  std::vector<std::vector<vpPoint>> box;
  createCylinderBBox(start, end, shape.radius, box);
  addPolygon(box, face, shape.name, usesLod(shape), smallestLine(shape));
  addProjectionErrorPolygon(box, face, shape.name, usesLod(shape), smallestLine(shape));
  initProjectionErrorCylinder(start, end, shape.radius, axis, shape.name);
  face += 4;
}

void vpMbMultiCueTracker::addCaoCircle(const vpCaoShape &shape, int &face)
{
  const std::vector<vpPoint> &points = shape.points;
  addPolygon(points[0], points[1], points[2], shape.radius, face, shape.name, usesLod(shape), smallestArea(shape));
  addProjectionErrorPolygon(points[0], points[1], points[2], shape.radius, face, shape.name, usesLod(shape),
                            smallestArea(shape));
  initProjectionErrorCircle(points[0], points[1], points[2], shape.radius, face++, shape.name);
}

END_VISP_NAMESPACE
