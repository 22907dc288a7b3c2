// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackedModelBuilder_h
#define vpTrackedModelBuilder_h

#include <visp3/model/vpTrackedModel.h>

BEGIN_VISP_NAMESPACE

namespace vpMeshDetail {
struct BoundingBox;
struct ModelParts;
class VertexPool;
} // namespace vpMeshDetail

/*!
  \ingroup group_model_geometry
  How raw geometry becomes a model.
*/
struct VISP_EXPORT vpModelOptions
{
  double unit = 1.; //!< Metres per unit of a mesh file: 1 (m), 0.01 (cm), 0.001 (mm); > 0.
  double creaseAngle =
      30.; //!< Angle between neighbouring triangles' normals above which their edge is tracked, degrees, (0, 180).
  double weldTolerance = 1e-6; //!< Vertices closer than this share of the diameter are one; [0, 0.01].
  double minSize = 1e-3;       //!< Smallest diameter that is believed, metres, > 0.
  double maxSize = 30.;        //!< Largest diameter that is believed, metres, > minSize.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_model_geometry
  Collects geometry and makes a vpTrackedModel of it.

  Two kinds of input, which may be mixed: the primitives of ViSP's model files (addFace, addLine, addCylinder,
  addCircle), all of whose edges are tracked, and a triangle soup (addTriangle), whose edges are found: creases by
  dihedral angle and borders. Coordinates are object frame, in metres for the primitives, in the file's unit for
  triangles.
*/
class VISP_EXPORT vpTrackedModelBuilder
{
public:
  //! \throw vpException where an option is out of range.
  explicit vpTrackedModelBuilder(const vpModelOptions &options = vpModelOptions());

  const vpModelOptions &options() const { return m_options; }

  /*!
    A polygon whose boundary is tracked where it faces the camera.
    \param corners At least 3, in order, counter-clockwise seen from outside, in a plane, not necessarily convex.
    \param name, polygon See vpModelFace.
    \param closed False where the edge from the last corner to the first is not to be tracked.
    \throw vpException where there are less than 3 corners.
  */
  void addFace(const std::vector<Eigen::Vector3d> &corners, const std::string &name = "", int polygon = -1,
               bool closed = true);
  //! A line that is seen from all sides unless the surface hides it.
  void addLine(const Eigen::Vector3d &start, const Eigen::Vector3d &end, const std::string &name = "",
               int polygon = -1);
  //! A cylinder given by the ends of its axis and its radius (> 0). \throw vpException where the radius is not
  //! positive.
  void addCylinder(const Eigen::Vector3d &start, const Eigen::Vector3d &end, double radius,
                   const std::string &name = "", int polygon = -1);
  //! A circle given by its centre, two more points of its plane (counter-clockwise from the seen side) and its radius
  //! (> 0). \throw vpException where the radius is not positive.
  void addCircle(const Eigen::Vector3d &centre, const Eigen::Vector3d &second, const Eigen::Vector3d &third,
                 double radius, const std::string &name = "", int polygon = -1);

  //! A corner of a mesh's triangle.
  struct Corner
  {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();      //!< Object frame, in the file's unit.
    Eigen::Vector3f color = Eigen::Vector3f::Constant(0.5F); //!< Red, green, blue in [0, 1].
    Eigen::Vector2f texture = Eigen::Vector2f::Zero();       //!< u right, v down.
  };
  /*!
    A triangle of a mesh. The model has colours where one of them differs from the default, and texture where a triangle
    has an image.
    \param corners Counter-clockwise seen from outside where that is known; windings are repaired.
    \param image What addImage() returned, -1 for none.
    \throw vpException where there is no such image.
  */
  void addTriangle(const std::array<Corner, 3> &corners, int image = -1);
  /*!
    \param image A texture image, or an empty one in place of an image that could not be read: it is counted in the
    report.
    \return Its index for addTriangle(), -1 for an empty one.
  */
  int addImage(const vpImage<vpRGBa> &image);
  //! Has the report say what may be wrong with the file; the same text once only.
  void addWarning(const std::string &text);

  /*!
    Welds, repairs windings, finds creases, borders and curved faces, fills the report.
    Border loops whose bounding box is smaller than 5 % of the diameter are taken for holes of a scan: they are reported
    but not tracked. The builder can be used again afterwards; what was added stays.
    \param file Name for the report and for messages.
    \throw vpException where there is nothing to track, a coordinate is not finite, or the diameter is outside
    [minSize, maxSize]; the text names file and size and says what to do.
  */
  vpTrackedModel build(const std::string &file) const;

private:
  struct Primitive
  {
    std::vector<Eigen::Vector3d> points;
    double radius = 0.;
    std::string name;
    int polygon = -1;
    bool closed = true;
  };

  void checkFinite(const std::string &file) const;
  vpMeshDetail::BoundingBox measure(const std::string &file) const;
  void checkSize(double diameter, const std::string &file) const;
  void assemblePrimitives(const std::string &file, vpMeshDetail::ModelParts &parts,
                          vpMeshDetail::VertexPool &pool) const;
  void assembleMesh(vpMeshDetail::ModelParts &parts, vpMeshDetail::VertexPool &pool) const;

  vpModelOptions m_options;
  std::vector<Primitive> m_faces;
  std::vector<Primitive> m_lines;
  std::vector<Primitive> m_cylinders;
  std::vector<Primitive> m_circles;
  std::vector<std::array<Eigen::Vector3d, 3>> m_triangles;
  vpModelAppearance m_appearance; //!< Of m_triangles; its vectors stay empty until a triangle needs them.
  std::size_t m_missingImages = 0;
  std::vector<std::string> m_warnings;
};

END_VISP_NAMESPACE
#endif
