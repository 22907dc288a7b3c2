// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpModelView_h
#define vpModelView_h

#include <visp3/model/vpModelRenderer.h>

BEGIN_VISP_NAMESPACE

//! \ingroup group_model_view Where a control point lies on the object as it is seen.
enum class vpEdgeKind
{
  SILHOUETTE, //!< Background behind the edge.
  INNER       //!< Another part of the object behind the edge, or surface on both sides.
};

/*! \ingroup group_model_view A point of the object's edges that is seen from one pose ([P14] III-A). */
struct vpControlPoint
{
  Eigen::Vector3d position;  //!< Object frame, metres.
  Eigen::Vector3d direction; //!< Unit direction of the edge there, object frame.
  Eigen::Vector2d pixel;     //!< Projection (u, v), pixels.
  Eigen::Vector2d normal;    //!< Unit normal of the edge in the image (u, v); away from the object for a silhouette.
  vpEdgeKind kind = vpEdgeKind::SILHOUETTE;
  bool slides =
      false; //!< True on a curved surface's rim, where another point of the surface is the rim once the pose changes.
  int contour = -1;      //!< Index into vpModelView::contours().
  double arcLength = 0.; //!< Along the contour from its start, pixels.
  int edge = -1;         //!< A number that names the model edge in every view, -1 on rims of curved meshes.
  double parameter = 0.; //!< Place along the model edge, [0, 1].
};

/*! \ingroup group_model_view A run of consecutive control points. */
struct vpContour
{
  int first = 0;        //!< Index of its first control point.
  int count = 0;        //!< Number of control points.
  bool straight = true; //!< True for the image of a straight line.
};

/*! \ingroup group_model_view How a view is taken. */
struct VISP_EXPORT vpModelViewOptions
{
  double sampleStep = 4.;                  //!< Distance of control points along an edge, pixels, >= 0.5.
  double appearAngle = 1.5533430342749532; //!< A face is seen below this angle between normal and line of sight,
                                           //!< radians, (0, pi/2]; 89 deg.
  double disappearAngle =
      1.5533430342749532;            //!< A face that was seen is so up to this angle, radians, [appearAngle, pi/2].
  double nearDistance = 0.001;       //!< Nothing closer is seen, metres, > 0.
  double farDistance = 0.;           //!< Nothing farther is seen, metres; 0: no limit.
  double border = 2.;                //!< Points closer to the image border are left out, pixels, >= 0.
  unsigned int visibilitySize = 192; //!< Largest side of the depth buffer that hides edges, pixels, >= 16.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*! \ingroup group_model_view Level of detail of one polygon, as ViSP's setLod() has it. */
struct vpFaceDetail
{
  bool enabled = false;
  double minLineLength = 50.;    //!< Shorter edges are left out, pixels.
  double minPolygonArea = 2500.; //!< Smaller faces are left out, square pixels.
};

/*!
  \ingroup group_model_view
  The control points that are visible from a pose, for polyhedra and for curved meshes.

  Straight edges, circles and cylinder limbs come from the model; the rims of curved faces are where the interpolated
  corner normals are perpendicular to the line of sight. All are clipped, sampled evenly in the image and kept where the
  depth buffer does not hide them (a convex object needs no such buffer). Memory is used again from call to call.
*/
class VISP_EXPORT vpModelView
{
public:
  /*!
    \param model, renderer Have the same model; \e renderer may be null for a convex model.
    \param cMo Pose of the object in the camera frame.
    \param cam Camera without distortion.
    \param imageWidth, imageHeight Pixels, > 0.
    \param options How to look.
  */
  void compute(const vpTrackedModel &model, vpModelRenderer *renderer, const vpHomogeneousMatrix &cMo,
               const vpCameraParameters &cam, unsigned int imageWidth, unsigned int imageHeight,
               const vpModelViewOptions &options);

  const std::vector<vpControlPoint> &points() const { return m_points; }
  const std::vector<vpContour> &contours() const { return m_contours; }
  //! Per face of the model: 1 where it faces the camera.
  const std::vector<char> &facesSeen() const { return m_facesSeen; }
  //! True where a rim slides over a curved surface: the view is then good for small motions only.
  bool hasSlidingRims() const { return m_hasSlidingRims; }

private:
  std::vector<vpControlPoint> m_points;
  std::vector<vpContour> m_contours;
  std::vector<char> m_facesSeen;
  bool m_hasSlidingRims = false;
};

END_VISP_NAMESPACE
#endif
