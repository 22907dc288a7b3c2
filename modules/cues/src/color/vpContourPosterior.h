// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpContourPosterior_h
#define vpContourPosterior_h

#include <visp3/cues/vpColorCue.h>

#include <array>

BEGIN_VISP_NAMESPACE

/*!
  Where on a line the contour is, from what the histograms say of its pixels.

  Pixels are taken together in segments of \e scale pixels: the product of their probabilities. For every border c
  between two segments within reach, p(c) is the product over the segments around it of h p_O + (1 - h) p_B, where h is
  a smooth step from the object's side to the background's that never gets to 0 or 1, for no pixel is that certain.
  Mean and variance of p give the line's row.
*/
class vpContourPosterior
{
public:
  static constexpr int borders = 6; //!< To both sides of the one in the middle.
  static constexpr int around = 4;  //!< Segments that count on both sides of a border.

  //! \return Pixels that a line has on both sides.
  static int reach(unsigned int scale) { return (borders + around) * static_cast<int>(scale) + 1; }

  //! \param scale Pixels of a segment.
  vpContourPosterior(const vpColorCue &cue, unsigned int scale);

  //! Sets offset and scale of \e line. \param pixels Of the line, by offset.
  void evaluate(const std::uint32_t *pixels, vpColorCue::Line &line) const;

private:
  static constexpr int half = borders + around;
  using Segments = std::array<float, 2 * half>;

  // Of a border, pixels.
  double placeOf(int border) const { return border * m_scale + (border > 0 ? 0.5 : border < 0 ? -0.5 : 0.); }
  void join(const std::uint32_t *pixels, const vpColorCue::Line &line, Segments &object) const;

  const vpColorHistograms &m_histograms;
  int m_scale;
  double m_contourVariance;             // Variances of a contour's place, square pixels: by the model,
  double m_spread;                      // by the segments' size,
  double m_noInformation;               // and where it may be anywhere within reach.
  std::array<float, 2 * around> m_step; // 2 h - 1 of the segments around a border, from inside outwards.
};

END_VISP_NAMESPACE
#endif
