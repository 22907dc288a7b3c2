// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpGradientAngle_h
#define vpGradientAngle_h

#include <visp3/core/vpMatrix.h>
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

  //! The mean over places that are given one by one.
  class Mean
  {
  public:
    //! \param I Image. \param sobelX, sobelY Kernels of the gradient to the right and down, of the same odd size.
    Mean(const vpImage<unsigned char> &I, const vpMatrix &sobelX, const vpMatrix &sobelY)
        : m_I(I), m_sobelX(sobelX), m_sobelY(sobelY)
    {
    }
    //! \param u, v Pixel; one without room for the kernel is left out. \param normal Of the edge there, unit length.
    //! \return The gradient there.
    Eigen::Vector2d add(double u, double v, const Eigen::Vector2d &normal);
    //! In [0, 90]; 90 where nothing was added.
    double degrees() const;

  private:
    const vpImage<unsigned char> &m_I;
    const vpMatrix &m_sobelX;
    const vpMatrix &m_sobelY;
    double m_sum = 0.;
    unsigned int m_count = 0;
  };
};

END_VISP_NAMESPACE
#endif
