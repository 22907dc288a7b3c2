// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpVrmlScene.h"

#include <visp3/core/vpConfig.h>

#ifdef VISP_HAVE_COIN3D
#include <visp3/core/vpException.h>
#include <visp3/se3/vpExactNumber.h>

#include <Inventor/VRMLnodes/SoVRMLCoordinate.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedFaceSet.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedLineSet.h>
#include <Inventor/VRMLnodes/SoVRMLShape.h>
#include <Inventor/VRMLnodes/SoVRMLTransform.h>
#include <Inventor/misc/SoChildList.h>
#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoIndexedShape.h>
#include <Inventor/nodes/SoNonIndexedShape.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoVertexProperty.h>

#include <algorithm>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

namespace {
constexpr int deepest = 200;
// Of a face four or more; it takes 6.3 KB with what vpMbTracker keeps of it, and all of them are to stay below 1 GB.
constexpr long mostValues = 600000;

[[noreturn]] void refuse(const std::string &reason)
{
  throw vpException(vpException::badValue, reason);
}

std::string nameOf(const SoNode &node)
{
  const std::string type = node.getTypeId().getName().getString();
  const std::string name = node.getName().getString();
  return name.empty() ? type : type + " '" + name + "'";
}

void requireIndices(const SoMFInt32 &indices, int points, const std::string &where)
{
  for (int i = 0; i < indices.getNum(); ++i) {
    if (indices[i] < -1 || indices[i] >= points) {
      refuse("index " + std::to_string(indices[i]) + " in coordIndex of " + where + " is out of range: there are " +
             std::to_string(points) + " points, the first is 0");
    }
  }
}

// What is nested too deep contains itself: USE inside of its DEF.
class Guard
{
public:
  void enter()
  {
    if (++m_depth > deepest) {
      refuse("nodes are nested more than " + std::to_string(deepest) + " deep: does a DEF hold a USE of itself?");
    }
    count(1);
  }
  void leave() { --m_depth; }
  void count(int values)
  {
    m_values += values;
    if (m_values > mostValues) {
      refuse("the scene has more than " + std::to_string(mostValues) + " nodes and indices, with every USE counted");
    }
  }

private:
  int m_depth = 0;
  long m_values = 0;
};

bool isIdentity(const SoVRMLTransform &transform)
{
  return transform.translation.getValue() == SbVec3f(0.F, 0.F, 0.F) &&
         transform.scale.getValue() == SbVec3f(1.F, 1.F, 1.F) &&
         transform.rotation.getValue() == SbRotation::identity();
}

// ViSP does not know center and scaleOrientation, and scales after it has turned.
void requirePlain(const SoVRMLTransform &transform)
{
  const SbVec3f scale = transform.scale.getValue();
  const bool turned = !(transform.rotation.getValue() == SbRotation::identity());
  const bool even = vpIsSame(scale[0], scale[1]) && vpIsSame(scale[1], scale[2]);
  const bool scaled = !(scale == SbVec3f(1.F, 1.F, 1.F));
  if ((transform.center.getValue() != SbVec3f(0.F, 0.F, 0.F) && (turned || scaled)) || (!even && turned) ||
      (!even && !(transform.scaleOrientation.getValue() == SbRotation::identity()))) {
    refuse(nameOf(transform) + " has a center, a scaleOrientation or an uneven scale that ViSP would misplace: export "
                               "the model with its transformations applied");
  }
}

class Vrml2Walk
{
public:
  const std::vector<std::string> &warnings() const { return m_warnings; }

  void node(const SoNode &node, bool moved)
  {
    const SoType type = node.getTypeId();
    if (type == SoVRMLGroup::getClassTypeId()) {
      group(static_cast<const SoVRMLGroup &>(node), moved);
    } else if (type == SoVRMLTransform::getClassTypeId()) {
      const auto &transform = static_cast<const SoVRMLTransform &>(node);
      requirePlain(transform);
      group(transform, moved || !isIdentity(transform));
    } else if (type == SoVRMLShape::getClassTypeId()) {
      shape(static_cast<const SoVRMLShape &>(node), moved);
    } else if (node.getChildren() != nullptr && node.getChildren()->getLength() > 0) {
      refuse("what is in " + nameOf(node) + " would be left out: put its shapes into a Group or Transform");
    }
  }

private:
  void group(const SoVRMLGroup &parent, bool moved)
  {
    m_guard.enter();
    for (int i = 0; i < parent.getNumChildren(); ++i) {
      node(*parent.getChild(i), moved);
    }
    m_guard.leave();
  }

  void shape(const SoVRMLShape &node, bool moved)
  {
    const SoNode *geometry = node.geometry.getValue();
    if (geometry == nullptr) {
      return;
    }
    const SoType type = geometry->getTypeId();
    if (type == SoVRMLIndexedFaceSet::getClassTypeId()) {
      const auto &faces = static_cast<const SoVRMLIndexedFaceSet &>(*geometry);
      const bool isCylinder = std::string(faces.getName().getString()).compare(0, 3, "cyl") == 0;
      indexed(faces, faces.coord.getValue(), faces.coordIndex, isCylinder);
    } else if (type == SoVRMLIndexedLineSet::getClassTypeId()) {
      const auto &lines = static_cast<const SoVRMLIndexedLineSet &>(*geometry);
      indexed(lines, lines.coord.getValue(), lines.coordIndex, false);
      if (moved) {
        refuse(nameOf(lines) + " lies in a Transform, which ViSP does not apply to lines: export the model with its "
                               "transformations applied");
      }
    } else {
      refuse(nameOf(*geometry) + " would be left out: only IndexedFaceSet and IndexedLineSet are read");
    }
  }

  void indexed(const SoNode &node, const SoNode *coord, const SoMFInt32 &indices, bool isCylinder)
  {
    const std::string where = nameOf(node);
    if (coord == nullptr || !coord->isOfType(SoVRMLCoordinate::getClassTypeId())) {
      refuse(where + " has no points (coord)");
    }
    const int points = static_cast<const SoVRMLCoordinate *>(coord)->point.getNum();
    m_guard.count(indices.getNum() + points);
    requireIndices(indices, points, where);
    if (isCylinder && (points < 6 || points % 2 != 0)) {
      refuse(where + " is a cylinder by its name and has " + std::to_string(points) +
             " points: two circles of three or more each are needed, or a name that does not start with cyl");
    }
    if (isCylinder) {
      return;
    }
    if (indices.getNum() > 0 && indices[indices.getNum() - 1] != -1) {
      refuse("coordIndex of " + where + " does not end in -1: ViSP would leave out the last face");
    }
    faces(indices, where);
  }

  void faces(const SoMFInt32 &indices, const std::string &where)
  {
    std::vector<int> corners;
    for (int i = 0; i < indices.getNum(); ++i) {
      if (indices[i] != -1) {
        corners.push_back(indices[i]);
        continue;
      }
      if (corners.size() == 1) {
        refuse("coordIndex of " + where + " has a face of one corner, index " + std::to_string(corners[0]));
      }
      std::sort(corners.begin(), corners.end());
      if (std::adjacent_find(corners.begin(), corners.end()) != corners.end() && m_warnings.empty()) {
        m_warnings.push_back("a face of " + where + " has a corner twice: is a -1 missing in coordIndex?");
      }
      corners.clear();
    }
  }

  std::vector<std::string> m_warnings;
  Guard m_guard;
};

class Vrml1Walk
{
public:
  void group(const SoGroup &node)
  {
    m_guard.enter();
    const int before = m_points;
    for (int i = 0; i < node.getNumChildren(); ++i) {
      child(*node.getChild(i));
    }
    if (node.isOfType(SoSeparator::getClassTypeId())) {
      m_points = before;
    }
    m_guard.leave();
  }

private:
  void child(const SoNode &node)
  {
    if (node.isOfType(SoGroup::getClassTypeId())) {
      group(static_cast<const SoGroup &>(node));
    } else if (node.isOfType(SoCoordinate3::getClassTypeId())) {
      m_points = static_cast<const SoCoordinate3 &>(node).point.getNum();
    } else if (node.isOfType(SoIndexedShape::getClassTypeId())) {
      const auto &shape = static_cast<const SoIndexedShape &>(node);
      m_guard.count(shape.coordIndex.getNum());
      requireIndices(shape.coordIndex, pointsOf(shape), nameOf(shape));
    } else if (node.isOfType(SoNonIndexedShape::getClassTypeId())) {
      refuse(nameOf(node) + " is not read: export the model as VRML 2 with IndexedFaceSet nodes");
    }
  }

  int pointsOf(const SoVertexShape &shape) const
  {
    const SoNode *own = shape.vertexProperty.getValue();
    const bool has = own != nullptr && own->isOfType(SoVertexProperty::getClassTypeId());
    return has ? static_cast<const SoVertexProperty *>(own)->vertex.getNum() : m_points;
  }

  Guard m_guard;
  int m_points = 1; // Coin's default is one point.
};
} // namespace

std::vector<std::string> requireWholeVrml2(const SoVRMLGroup &scene)
{
  Vrml2Walk walk;
  walk.node(scene, false); // Coin makes no group around a single node.
  return walk.warnings();
}

void requireWholeVrml1(const SoSeparator &scene)
{
  Vrml1Walk().group(scene);
}

END_VISP_NAMESPACE
#endif
