// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourSampler_h
#define vpContourSampler_h

#include "view/vpDepthProbe.h"
#include "view/vpViewCamera.h"

#include <visp3/model/vpModelView.h>

BEGIN_VISP_NAMESPACE

/*!
  Turns curves on the object into control points: pieces are added one after the other, clipped as they come, and
  sample() spreads points evenly over what is left of the curve, dropping the hidden ones.
*/
class vpContourSampler
{
public:
  vpContourSampler(vpModelView &view, const vpViewCamera &camera, const vpModelViewOptions &options,
                   const vpDepthProbe &depth);

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
  bool place(vpControlPoint &point, const vpModelView::Piece &piece, double s, double t) const;
  bool emit(const vpModelView::Piece &piece, double s, double arcLength);
  bool isInside(const Eigen::Vector2d &pixel) const;
  void orient(vpControlPoint &point, const Eigen::Vector3d &cX, const Eigen::Vector3d &outward, bool innerEdge) const;
  void orientByDepth(vpControlPoint &point, double depth) const;

  vpModelView &m_view;
  const vpViewCamera &m_camera;
  const vpModelViewOptions &m_options;
  vpDepthProbe m_depth;
  Eigen::Vector2d m_high; // Right and lower end of where control points may be, pixels.
  double m_tolerance;     // Depth differences below this do not hide.
  double m_sideOffset;    // How far beside an edge the depth buffer is asked, pixels.
  bool m_interrupted = true;
};

END_VISP_NAMESPACE
#endif
