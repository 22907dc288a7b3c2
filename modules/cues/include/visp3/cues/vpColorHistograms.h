// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpColorHistograms_h
#define vpColorHistograms_h

#include <visp3/se3/vpCompatibility.h>

#include <cstddef>
#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_color
  How often each colour was seen on the object and around it, and what that makes of a pixel: the object or the
  background. Colours are counted in 16 steps of each of three channels, gray levels in 64.

  Pixels are handed over as in vpImage<vpRGBa>'s memory, red in the lowest byte, or as a gray level.
*/
class VISP_EXPORT vpColorHistograms
{
public:
  enum Side
  {
    OBJECT,
    BACKGROUND
  };

  vpColorHistograms() { reset(3); }

  //! Forgets everything. \param channels 1 or 3.
  void reset(unsigned int channels);
  unsigned int channels() const { return m_channels; }
  //! True once something was learnt.
  bool isKnown() const { return m_isKnown; }

  //! Counts a pixel for the next learn().
  void count(std::uint32_t pixel, Side side) { ++m_counts[side][bin(pixel)]; }
  /*!
    Mixes what was counted into what is known, and forgets the counts. Where one side was not counted at all, that side
    stays as it is; the first counts are taken over whole.
    \param rate Share of the counts, [0, 1].
  */
  void learn(double rate);

  //! Probability that a pixel of this colour belongs to the object, both sides equally likely beforehand; inside (0,
  //! 1).
  float object(std::uint32_t pixel) const { return m_object[bin(pixel)]; }

private:
  std::size_t bin(std::uint32_t pixel) const
  {
    return m_channels == 1 ? pixel >> 2U : ((pixel & 0xF0U) << 4U) | ((pixel >> 8U) & 0xF0U) | ((pixel >> 20U) & 0x0FU);
  }

  unsigned int m_channels = 0;
  bool m_isKnown = false;
  std::vector<std::uint32_t> m_counts[2];
  std::vector<float> m_frequency[2];
  std::vector<float> m_object;
};

END_VISP_NAMESPACE
#endif
