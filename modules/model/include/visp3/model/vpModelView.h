// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelView_h
#define vpModelView_h

#include <visp3/model/vpModelRenderer.h>
#include <visp3/model/vpTextureEdges.h>

BEGIN_VISP_NAMESPACE

//! \ingroup group_model_view
//! Where a control point lies on the object as it is seen.
enum class vpEdgeKind
{
  SILHOUETTE, //!< Background behind the edge.
  INNER       //!< Another part of the object behind the edge, or surface on both sides.
};

/*!
  \ingroup group_model_view
  A point of the object's edges that is seen from one pose ([P14] III-A).
*/
struct vpControlPoint
{
  Eigen::Vector3d position;  //!< Object frame, metres.
  Eigen::Vector3d direction; //!< Unit direction of the edge there, object frame.
  Eigen::Vector2d pixel;     //!< Projection (u, v), pixels.
  Eigen::Vector2d normal;    //!< Unit normal of the edge in the image (u, v); away from the object for a silhouette.
  vpEdgeKind kind = vpEdgeKind::SILHOUETTE;
  bool slides = false;   //!< True on a curved surface's rim: another point is the rim once the pose changes.
  double side = 1.;      //!< 1 where normal is the image of direction turned from u towards v, else -1.
  int contour = -1;      //!< Index into vpModelView::contours().
  double arcLength = 0.; //!< Along the contour from its start, pixels.
  int edge = -1;         //!< A number that names the model edge in every view, -1 on rims of curved meshes; see
                         //!< vpModelView::textureEdgeOf().
  double parameter = 0.; //!< Place along the model edge, [0, 1].
};

/*!
  \ingroup group_model_view
  A run of consecutive control points.
*/
struct vpContour
{
  int first = 0;        //!< Index of its first control point.
  int count = 0;        //!< Number of control points.
  bool straight = true; //!< True for the image of a straight line.
  double step = 0.;     //!< Distance of neighbouring control points along it, pixels.
};

/*!
  \ingroup group_model_view
  Level of detail of one face, as ViSP's setLod() has it, and whether it is tracked.
*/
struct vpFaceDetail
{
  bool enabled = false;
  double minLineLength = 50.;    //!< Shorter edges are left out, pixels.
  double minPolygonArea = 2500.; //!< Smaller faces are left out, square pixels.
  bool tracked = true;           //!< False: edges that no other face shows are left out.
};

/*!
  \ingroup group_model_view
  How a view is taken.
*/
struct VISP_EXPORT vpModelViewOptions
{
  double sampleStep = 4.;      //!< Distance of control points along an edge, pixels, >= 0.5.
  double appearAngle = 89.;    //!< A face is seen below this angle between normal and line of sight, degrees, (0, 90].
  double disappearAngle = 89.; //!< A face that was seen stays so up to this angle, degrees, [appearAngle, 90].
  double nearDistance = 0.001; //!< Nothing closer is seen, metres, > 0.
  double farDistance = 0.;     //!< Nothing farther is seen, metres; 0: no limit.
  double border = 2.;          //!< Points closer to the image border are left out, pixels, >= 0.
  unsigned int visibilitySize = 192; //!< Largest side of the depth buffer that hides edges, pixels, >= 16.
  bool allEdges = false;             //!< Edges of the faces that are turned away count as seen too.
  std::vector<vpFaceDetail> details; //!< Per face of the model; empty: every face in full detail.
  bool textureEdges = false;         //!< Edges of the model's texture are control points, too; at most as many as those
                                     //!< of its geometry.
  std::vector<char> textureEdgesLeftOut; //!< Per edge of the texture: 1 where it is not to be used; empty: all are.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

class vpModelTopology;
class vpDepthProbe;
struct vpViewCamera;
class vpTextureSource;

/*!
  \ingroup group_model_view
  The control points that are visible from a pose, for polyhedra and for curved meshes.

  Straight edges, circles and cylinder limbs come from the model; the rims of curved faces are where the interpolated
  corner normals are perpendicular to the line of sight. All are clipped, sampled evenly in the image and kept where the
  depth buffer does not hide them (a convex object needs no such buffer). Edges of the texture come last, the best ones
  first; what runs nearer than 6 pixels beside an edge before it is left out, as the two would be confused. Nothing is
  allocated once the memory of an earlier call suffices, but for the few bytes by which a mesh of many triangles hands
  half of its work to one of OpenCV's threads. Copies share what is derived from the model.
*/
class VISP_EXPORT vpModelView
{
public:
  //! Prepares what depends on the model alone. \param model Not null; kept alive by the view.
  explicit vpModelView(const std::shared_ptr<const vpTrackedModel> &model);

  /*!
    \param cMo Pose of the object in the camera frame.
    \param cam Camera without distortion (distortion coefficients are ignored).
    \param imageWidth, imageHeight Pixels, > 0.
    \param options How to look; not checked here.
    \param renderer Draws the depth buffer of the same model; not used for a convex one, null there.
    \param keepDepth Hides edges by the depth buffer that is there, moved to where the object is now: for poses that
    move the object's points by a few pixels, turns included, which costs a fraction of drawing it. Camera, image size
    and options have to be those of the last call; where there is no buffer yet, one is drawn.
  */
  void compute(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int imageWidth,
               unsigned int imageHeight, const vpModelViewOptions &options, vpModelRenderer *renderer,
               bool keepDepth = false);

  //! Lets the next compute() take the faces that another view of the same model sees for those seen before.
  void continueFrom(const vpModelView &other) { m_facesSeen = other.m_facesSeen; }

  const vpTrackedModel &model() const { return *m_model; }
  //! The pose that was given to compute() last.
  const vpHomogeneousMatrix &pose() const { return m_cMo; }
  //! The depth buffer that the last compute() used, at its own scale; null where there is none.
  const vpRenderedView *depth() const { return m_hasDepth ? &m_depth : nullptr; }
  //! The pose that depth() was drawn for.
  const vpHomogeneousMatrix &depthPose() const { return m_depthPose; }
  const std::vector<vpControlPoint> &points() const { return m_points; }
  const std::vector<vpContour> &contours() const { return m_contours; }
  //! Per face of the model: 1 where it is seen, as far as its own orientation, size and place decide.
  const std::vector<char> &facesSeen() const { return m_facesSeen; }
  //! Number of names that vpControlPoint::edge can have: straight edges, two limbs for each cylinder, circles, and the
  //! edges of the texture where the last compute() used them.
  int edgeNames() const;
  //! The edges of the texture; they are found when first asked for, here or by compute().
  const std::vector<vpTextureEdge> &textureEdges() const;
  //! Index into textureEdges(), -1 for a point of the geometry.
  int textureEdgeOf(const vpControlPoint &point) const;
  //! True where a rim slides over a curved surface: the view then serves small motions only.
  bool hasSlidingRims() const { return m_hasSlidingRims; }

private:
  friend class vpContourSampler;
  friend class vpRimTracer;
  friend class vpCurves;
  friend class vpTextureContours;

  // A straight bit of a curve, clipped to what the camera sees.
  struct Piece
  {
    std::array<Eigen::Vector3d, 2> position;  // Ends, object frame.
    std::array<Eigen::Vector3d, 2> direction; // Of the curve at the ends, object frame, any length.
    std::array<Eigen::Vector3d, 2> outward;   // Away from the surface at the ends, object frame; zero: not known.
    std::array<Eigen::Vector2d, 2> pixel;
    std::array<double, 2> depth;
    std::array<double, 2> parameter;
    double length = 0.;                    // Pixels.
    const vpModelCircle *circle = nullptr; // The circle that it is a chord of.
    int edge = -1;
    bool slides = false;
    bool innerEdge = false; // Surface seen on both sides.
    bool joined = false;    // Starts where the piece before it ends.
  };

  // Where a rim crosses the side of a triangle; object frame.
  struct RimNode
  {
    Eigen::Vector3d position;
    Eigen::Vector3d direction; // Of the rim, any length.
    Eigen::Vector3d outward;   // Away from the surface; zero: not known.
    bool joined;               // With the node before it.
  };

  void drawDepth(const vpCameraParameters &cam, unsigned int imageWidth, unsigned int imageHeight,
                 const vpModelViewOptions &options, vpModelRenderer &renderer);
  vpDepthProbe depthProbe(const vpViewCamera &camera) const;

  std::shared_ptr<const vpTrackedModel> m_model;
  std::shared_ptr<const vpModelTopology> m_topology;
  std::shared_ptr<vpTextureSource> m_texture;
  vpHomogeneousMatrix m_cMo;
  vpRenderedView m_depth;
  bool m_hasDepth = false;
  vpHomogeneousMatrix m_depthPose;
  std::vector<vpControlPoint> m_points;
  std::vector<vpContour> m_contours;
  std::vector<char> m_facesSeen;
  std::vector<float> m_facing; // Of the smooth triangles' corners: negative towards the camera.
  std::vector<char> m_visited; // Smooth triangles that a rim was traced over.
  std::vector<RimNode> m_rims; // One curve after the other.
  std::vector<std::size_t> m_rimEnds;
  std::vector<Piece> m_pieces; // Of the curve being sampled.
  std::vector<int> m_cells;    // Where control points are, see vpPointGrid.
  std::vector<int> m_cellNext;
  bool m_hasSlidingRims = false;
  bool m_hasTextureEdges = false;
};

END_VISP_NAMESPACE
#endif
