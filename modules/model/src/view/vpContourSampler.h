// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourSampler_h
#define vpContourSampler_h

#include <visp3/model/vpModelView.h>

BEGIN_VISP_NAMESPACE

//! Pose and camera in the form that projection needs.
struct vpViewCamera
{
  vpViewCamera(const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, unsigned int width, unsigned int height);

  Eigen::Vector3d toCamera(const Eigen::Vector3d &oX) const { return cRo * oX + cto; }
  Eigen::Vector2d project(const Eigen::Vector3d &cX) const
  {
    return Eigen::Vector2d(px * cX.x() / cX.z() + u0, py * cX.y() / cX.z() + v0);
  }

  Eigen::Matrix3d cRo;
  Eigen::Vector3d cto;
  Eigen::Vector3d oC; //!< The camera's centre, object frame.
  double px, py, u0, v0;
  double width, height;
};

/*!
  Turns curves on the object into control points: pieces are added one after the other, clipped as they come, and
  sample() spreads points evenly over what is left of the curve, dropping the hidden ones.
*/
class vpContourSampler
{
public:
  vpContourSampler(vpModelView &view, const vpViewCamera &camera, const vpModelViewOptions &options, bool hasDepth);

  //! Ends, direction, outward, parameter and the flags of \e piece are read; the rest is filled here.
  void add(const vpModelView::Piece &piece);
  //! Ends the run of joined pieces: what comes next starts a new contour.
  void interrupt() { m_interrupted = true; }
  //! Makes the control points of all pieces added since the last call. \param straight For vpContour::straight.
  void sample(bool straight);

private:
  //! Keeps the share [s0, s1] of the piece's length in space.
  static void cut(vpModelView::Piece &piece, double s0, double s1);
  bool clipDepth(vpModelView::Piece &piece) const;
  bool clipImage(vpModelView::Piece &piece) const;
  void sampleRun(std::size_t first, std::size_t last, double total, bool straight);
  bool emit(const vpModelView::Piece &piece, double s, double arcLength);
  bool isHidden(const Eigen::Vector2d &pixel, double depth) const;
  void orient(vpControlPoint &point, const Eigen::Vector3d &cX, const Eigen::Vector3d &outward, bool innerEdge) const;
  void orientByDepth(vpControlPoint &point, double depth) const;
  float depthAt(const Eigen::Vector2d &pixel) const;

  vpModelView &m_view;
  const vpViewCamera &m_camera;
  const vpModelViewOptions &m_options;
  bool m_hasDepth;
  double m_tolerance;  // Depth differences below this do not hide.
  double m_sideOffset; // How far beside an edge the depth buffer is asked, pixels.
  bool m_interrupted = true;
};

END_VISP_NAMESPACE
#endif
