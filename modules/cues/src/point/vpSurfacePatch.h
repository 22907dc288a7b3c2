// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSurfacePatch_h
#define vpSurfacePatch_h

#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <array>

BEGIN_VISP_NAMESPACE

/*!
  What a point's surface looked like in one image, and the search for it in another one seen from elsewhere. Brightness
  and contrast may change. All coordinates are those of the pixels given.
*/
class vpSurfacePatch
{
public:
  static constexpr int half = 5; //!< The patch that is compared has 2 half + 1 pixels a side.

  //! What is believed to be the patch.
  struct Limits
  {
    float reach;            //!< How far from the start it may be, pixels.
    float leastCorrelation; //!< At noise of a quarter of the patch's contrast it is 0.94.
  };

  //! Takes the patch around a place, which may lie between pixels. Goes on with the border outside.
  void take(const cv::Mat &pixels, const cv::Point2f &place);

  //! True where align() can look for a picture that is distorted so.
  static bool isSimilar(const Eigen::Matrix2d &distortion);

  /*!
    Moves a place to where the patch fits best, to a fraction of a pixel.
    \param pixels Where to look. \param distortion The images, as columns, of what was one pixel to the right and one
    down. \param place Where to start, and the result. \param reach How far it may move, pixels. \return False where it
    does not fit.
  */
  bool align(const cv::Mat &pixels, const Eigen::Matrix2d &distortion, const Limits &limits, cv::Point2f &place) const;

private:
  // Enough for the patch turned by 45 degrees and 1.5 times as large.
  static constexpr int storedHalf = 14;
  static constexpr int storedSide = 2 * storedHalf + 1;

  bool warp(const Eigen::Matrix2d &distortion, float *values) const;

  std::array<unsigned char, storedSide * storedSide> m_stored{};
};

END_VISP_NAMESPACE
#endif
