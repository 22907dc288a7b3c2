// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackedModel_h
#define vpTrackedModel_h

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_geometry
  A piece of surface: one polygon of a .cao or .wrl file, or the triangles of a mesh that no crease separates.
*/
struct vpModelFace
{
  std::string name;                                 //!< Name in the model file, may be empty.
  int polygon = -1;                                 //!< Index of the polygon in the model file, -1 for a mesh.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); //!< Unit outward normal, object frame; mean one if not planar.
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); //!< Mean of a polygon's corners, centroid of a mesh face; metres.
  bool planar = true;                               //!< True where one normal serves the whole face.
  bool oriented = true;                             //!< True where the back of the face can never be seen.
  std::vector<int> corners;                         //!< Vertices in order, for a planar face of a .cao or .wrl file.
};

/*!
  \ingroup group_model_geometry
  A straight edge that is looked for in the image wherever it is not hidden.
*/
struct vpModelEdge
{
  std::array<int, 2> vertex = {{-1, -1}}; //!< Its ends.
  int firstFace = 0;                      //!< Where its faces start in vpTrackedModel::edgeFaces().
  int faceCount = 0;                      //!< Number of faces that share it; 0: a line in space, seen from all sides.
  int line = -1; //!< A face without triangles that carries the name and polygon index of a line, -1 for other edges.
};

/*!
  \ingroup group_model_geometry
  A triangle of the surface.
*/
struct vpModelTriangle
{
  std::array<int, 3> vertex = {{-1, -1, -1}}; //!< Counter-clockwise seen from outside.
  std::array<int, 3> normal = {{-1, -1, -1}}; //!< Corner normals, indices into vpTrackedModel::normals().
  int face = -1;                              //!< The face that it belongs to.
};

/*!
  \ingroup group_model_geometry
  A cylinder's mantle; its limbs are edges in the image.
*/
struct vpModelCylinder
{
  std::array<Eigen::Vector3d, 2> axis; //!< Ends of the axis, object frame, metres.
  double radius = 0.;                  //!< Metres, > 0.
  int face = -1;                       //!< The face of its mantle.
};

/*!
  \ingroup group_model_geometry
  A circle drawn on the object.
*/
struct vpModelCircle
{
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); //!< Object frame, metres.
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); //!< Unit normal of its plane, towards the side it is seen from.
  double radius = 0.;                               //!< Metres, > 0.
  int face = -1;                                    //!< A face without triangles that carries name and polygon index.
};

/*!
  \ingroup group_model_geometry
  Colours of the surface; every vector is empty where the file has none. Where a triangle has an image, the image alone
  gives its colour.
*/
struct vpModelAppearance
{
  std::vector<std::array<Eigen::Vector3f, 3>> color;   //!< Per triangle and corner: red, green, blue in [0, 1].
  std::vector<std::array<Eigen::Vector2f, 3>> texture; //!< Per triangle and corner: u right, v down, from 0 at the
                                                       //!< image's first pixel to 1; beyond 1 the image repeats.
  std::vector<int> image;                              //!< Per triangle: index into images, -1 for none.
  std::vector<vpImage<vpRGBa>> images;                 //!< Texture images.
};

/*!
  \ingroup group_model_geometry
  What was found when a model was loaded: read it before blaming the tracker.
*/
struct vpModelReport
{
  std::string file;                                       //!< What was read.
  double unit = 1.;                                       //!< Metres per unit of the file.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();         //!< Extent of the bounding box along x, y, z, metres.
  double diameter = 0.;                                   //!< Diagonal of the bounding box, metres.
  Eigen::Vector3d centreOffset = Eigen::Vector3d::Zero(); //!< Centre of the bounding box in the object frame, metres.
  std::size_t vertices = 0;                               //!< After welding.
  std::size_t triangles = 0;                              //!< Without the degenerate ones.
  std::size_t faces = 0;
  std::size_t edges = 0; //!< Straight edges that are tracked.
  std::size_t cylinders = 0;
  std::size_t circles = 0;
  std::size_t weldedVertices = 0;      //!< Positions that fell together with a slightly different one.
  std::size_t degenerateTriangles = 0; //!< Triangles without area that were dropped.
  std::size_t duplicateTriangles = 0;  //!< Triangles with the same three vertices as another one that were dropped.
  std::size_t flippedTriangles = 0;    //!< Triangles turned over because their neighbours disagreed.
  std::size_t flippedFaces = 0;      //!< Polygons of a .cao or .wrl wound against a neighbour (reported, not changed).
  std::size_t borderEdges = 0;       //!< Edges with one triangle, or one polygon, only.
  std::size_t holes = 0;             //!< Closed loops of a mesh's border edges.
  std::size_t nonManifoldEdges = 0;  //!< Edges with more than two triangles, or polygons.
  std::size_t missingImages = 0;     //!< Texture images that the file names and that could not be read.
  std::vector<std::string> warnings; //!< What the file lacks or may have lost, in whole sentences or parts of them.
  bool closed = false;               //!< A surface without border edges.
  bool convex = false;               //!< Nothing of the object can hide another part of it.
};

/*!
  \ingroup group_model_geometry
  Prints a report in a few lines, lengths with their unit.
*/
VISP_EXPORT std::ostream &operator<<(std::ostream &os, const vpModelReport &report);

/*!
  \ingroup group_model_geometry
  The geometry of the tracked object, in metres in the object frame; it does not change after it was built.

  Made by vpTrackedModelBuilder from polygons, lines, cylinders and circles (what ViSP's .cao and .wrl files contain) or
  by vpModelReader from a mesh. Triangles cover the whole surface, cylinders included, and serve to tell what is hidden;
  edges(), cylinders(), circles() and the rims of smoothTriangles() are what is looked for in the image.
*/
class VISP_EXPORT vpTrackedModel
{
public:
  const std::vector<Eigen::Vector3d> &vertices() const { return m_vertices; }
  //! Unit corner normals; corners that meet at a crease have normals of their own.
  const std::vector<Eigen::Vector3d> &normals() const { return m_normals; }
  const std::vector<vpModelTriangle> &triangles() const { return m_triangles; }
  const std::vector<vpModelFace> &faces() const { return m_faces; }
  const std::vector<vpModelEdge> &edges() const { return m_edges; }
  //! Faces of all edges, one after the other: see vpModelEdge::firstFace.
  const std::vector<int> &edgeFaces() const { return m_edgeFaces; }
  const std::vector<vpModelCylinder> &cylinders() const { return m_cylinders; }
  const std::vector<vpModelCircle> &circles() const { return m_circles; }
  //! Indices of the triangles of curved mesh faces: the ones over which an occluding contour can run.
  const std::vector<int> &smoothTriangles() const { return m_smoothTriangles; }
  const vpModelAppearance &appearance() const { return m_appearance; }
  const vpModelReport &report() const { return m_report; }

  //! Corners of the axis-aligned bounding box, object frame, metres.
  const Eigen::Vector3d &boxMin() const { return m_boxMin; }
  const Eigen::Vector3d &boxMax() const { return m_boxMax; }
  //! Middle of the bounding box, object frame, metres.
  Eigen::Vector3d centre() const { return 0.5 * (m_boxMin + m_boxMax); }
  //! Diagonal of the bounding box, metres.
  double diameter() const { return m_report.diameter; }
  //! True where no part of the object can hide another: front-facing is then the same as visible.
  bool isConvex() const { return m_report.convex; }

private:
  friend class vpTrackedModelBuilder;

  std::vector<Eigen::Vector3d> m_vertices;
  std::vector<Eigen::Vector3d> m_normals;
  std::vector<vpModelTriangle> m_triangles;
  std::vector<vpModelFace> m_faces;
  std::vector<vpModelEdge> m_edges;
  std::vector<int> m_edgeFaces;
  std::vector<vpModelCylinder> m_cylinders;
  std::vector<vpModelCircle> m_circles;
  std::vector<int> m_smoothTriangles;
  vpModelAppearance m_appearance;
  vpModelReport m_report;
  Eigen::Vector3d m_boxMin = Eigen::Vector3d::Zero();
  Eigen::Vector3d m_boxMax = Eigen::Vector3d::Zero();
};

END_VISP_NAMESPACE
#endif
