// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEdgeSearch_h
#define vpEdgeSearch_h

#include <visp3/cues/vpEdgeCue.h>

BEGIN_VISP_NAMESPACE

/*!
  Searches one image along short lines for edges across them. The image is read once per pixel of the line and of the
  mask's width; the gradient is a sum over that profile, so a long mask costs no more than a short one.
*/
class vpEdgeSearch
{
public:
  struct Extremum
  {
    double offset = 0.;   //!< Along the line, pixels.
    double contrast = 0.; //!< Gray levels, positive where it gets brighter along the line.
  };

  vpEdgeSearch(const vpImage<unsigned char> &I, const vpEdgeCueSettings &settings);

  /*!
    \param pixel, normal Middle and unit direction of the line, (u, v).
    \return The local extrema of the gradient above the contrast threshold, in order along the line; good until the next
    call.
  */
  const std::vector<Extremum> &along(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal);

private:
  bool findLimits(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal, int &low, int &high) const;
  void readProfile(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal, int low, int high);
  void findExtrema(int low, int high);
  float gradient(int index) const;

  const vpImage<unsigned char> &m_I;
  int m_range;
  int m_half; // Half the mask, pixels.
  double m_reach;
  float m_contrast;
  std::vector<float> m_kernel;  // Weights of the pixels at 1, 2, ... half on both sides.
  std::vector<float> m_profile; // Means across the line, from low - half to high + half.
  std::vector<float> m_gradient;
  std::vector<Extremum> m_extrema;
};

END_VISP_NAMESPACE
#endif
