// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMapEdges_h
#define vpMapEdges_h

#include <visp3/cues/vpOrientedDistanceMap.h>

BEGIN_VISP_NAMESPACE

/*!
  The edges of an image at reduced scale: averaged over blocks, smoothed by 1 2 1, Sobel's gradients, maxima along the
  gradient's greater component, above a threshold that knows the image's noise.

  Levels are integers throughout: a step of one gray level that is sharp in the map has a gradient of 48.
*/
class vpMapEdges
{
public:
  struct Edge
  {
    int x, y; //!< Map pixel of the region.
    int bin;  //!< Of vpOrientedDistanceMap.
  };

  /*!
    \param roi Whole blocks, but at the image's right and lower border.
    \param block Image pixels per map pixel.
    \return The edges row after row; good until the next call.
  */
  const std::vector<Edge> &find(const vpCueFrame &frame, const vpImageRegion &roi, int block,
                                const vpOrientedDistanceSettings &settings);
  double threshold() const { return m_threshold / gradientPerLevel; } //!< Gray levels.

private:
  static constexpr double gradientPerLevel = 48.;
  static constexpr int tile = 16; // Map pixels and side of what has one threshold.

  void reduce(const vpImage<unsigned char> &I, const vpImageRegion &roi, int block);
  void smooth();
  void differentiate();
  double gradientNoise();
  void chooseThresholds(const vpOrientedDistanceSettings &settings);
  double sumOfTile(int left, int top) const;
  double meanAround(int i, int j, int across, int down) const;
  void findMaxima();
  void dropMasked(const vpCueFrame &frame, const vpImageRegion &roi, int block);
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * m_columns + x); }
  int nearestRow(int y) const { return std::min(std::max(y, 0), m_rows - 1); }

  int m_columns = 0;
  int m_rows = 0;
  double m_threshold = 0.;
  std::vector<std::int16_t> m_levels;   // 4 times gray levels.
  std::vector<std::int16_t> m_smoothed; // 16 times gray levels.
  std::vector<std::int16_t> m_line[2];  // Sums along a column, with a pixel more on both sides.
  std::vector<std::int16_t> m_gradientU, m_gradientV;
  std::vector<std::int32_t> m_squares; // Of the gradient's length.
  std::vector<std::int32_t> m_maxima;  // The maxima among the squares of a row, 0 for what is none.
  std::vector<std::int32_t> m_samples; // What the noise is estimated of.
  std::vector<double> m_sums;          // Of the gradients' lengths in each tile.
  std::vector<std::int32_t> m_least;   // Threshold of each tile, squared.
  std::vector<Edge> m_found;
};

END_VISP_NAMESPACE
#endif
