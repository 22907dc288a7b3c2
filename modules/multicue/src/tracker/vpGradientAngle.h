// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpGradientAngle_h
#define vpGradientAngle_h

#include <visp3/model/vpModelView.h>

BEGIN_VISP_NAMESPACE

//! How well the directions of the image's gradient agree with the normals of a model's edges: ViSP's projection error.
class vpGradientAngle
{
public:
  /*!
    \param I Image as it was taken.
    \param view Control points at the pose in question.
    \param cam Camera of \e I.
    \return Mean angle, degrees in [0, 90]; 90 where no control point is inside the image.
  */
  static double mean(const vpImage<unsigned char> &I, const vpModelView &view, const vpCameraParameters &cam);
};

END_VISP_NAMESPACE
#endif
