// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEdgeSearch_h
#define vpEdgeSearch_h

#include <visp3/cues/vpEdgeCue.h>

#include <array>
#include <cstdint>

BEGIN_VISP_NAMESPACE

/*!
  Searches one image along short lines for edges across them. The image is read once per pixel of the line and of the
  mask's width; the gradient is a sum over that profile, so a long mask costs no more than a short one. All memory is
  inside the object, so that one can be made for every image.
*/
class vpEdgeSearch
{
public:
  struct Extremum
  {
    double offset = 0.;   //!< Along the line, pixels.
    double contrast = 0.; //!< Gray levels, positive where it gets brighter along the line.
  };

  //! The extrema of one line, in order along it, for the caller to sort and thin out.
  struct Extrema
  {
    Extremum *first;
    Extremum *last;   //!< Behind the last one.
    double brightest; //!< Gray level within vpLight::reach of the middle, mean over the mask's width; 255: unknown.
  };

  //! \param settings Checked: the memory suffices for the ranges of vpEdgeCueSettings.
  vpEdgeSearch(const vpImage<unsigned char> &I, const vpEdgeCueSettings &settings);

  /*!
    \param pixel, normal Middle and unit direction of the line, (u, v).
    \return The local extrema of the gradient above the contrast threshold; good until the next call.
  */
  Extrema along(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal);

private:
  static constexpr int maxRange = 100; // Of vpEdgeCueSettings::range.
  static constexpr int maxHalf = 7;    // Of vpEdgeCueSettings::maskSize, 15.
  static constexpr int maxLength = 2 * (maxRange + 1 + maxHalf) + 1;
  static constexpr int lanes = 8; // Samples that are interpolated at once.
  static constexpr int maxSamples = (maxLength * (2 * maxHalf + 1) + lanes - 1) / lanes * lanes;

  // What is read of the image, row after row beside the line. Gathered first and interpolated afterwards, because the
  // latter can be done for several samples in one instruction, the former cannot.
  struct Samples
  {
    std::array<unsigned char, 2 * maxSamples> upper; // Left and right pixel above each sample.
    std::array<unsigned char, 2 * maxSamples> lower; // Those below it.
    std::array<std::uint16_t, maxSamples> right;     // From the left pixel to the sample, 1 / 65536.
    std::array<std::uint16_t, maxSamples> down;
    std::array<std::uint16_t, maxSamples> level; // The result, 256 times the gray level.
  };

  bool findLimits(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal, int &low, int &high) const;
  void gather(const Eigen::Vector2d &pixel, const Eigen::Vector2d &normal, int first, int count);
  void interpolate(int count);
  void findGradient(int count);
  Extremum *findExtrema(int low, int high);
  double findBrightest(int first, int count) const;

  const vpImage<unsigned char> &m_I;
  int m_range;
  int m_half; // Half the mask, pixels.
  double m_reach;
  float m_contrast;
  std::array<float, maxHalf> m_kernel; // Weights of the pixels at 1, 2, ... half on both sides.
  Samples m_samples{};
  std::array<std::int32_t, maxLength> m_profile; // Sums across the line, 256 times gray levels.
  std::array<float, maxLength> m_gradient;
  std::array<Extremum, 2 * maxRange + 1> m_extrema;
};

END_VISP_NAMESPACE
#endif
