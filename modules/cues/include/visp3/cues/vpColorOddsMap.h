// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpColorOddsMap_h
#define vpColorOddsMap_h

#include <visp3/cues/vpColorHistograms.h>
#include <visp3/cues/vpCueFrame.h>
#include <visp3/cues/vpImageRegion.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_color
  For each place of a region, how much its colour speaks for the object and against the background: the logarithm of the
  odds of vpColorHistograms::object(), mean over 2 x 2 pixels. Computed once per frame for the likelihood of many poses;
  lookups may come from several threads. See \ref cues_distance_odds.
*/
class VISP_EXPORT vpColorOddsMap
{
public:
  static constexpr int block = 2;         //!< Image pixels per map pixel and side.
  static constexpr int stepsPerUnit = 16; //!< Steps of the map per unit of the natural logarithm.
  static constexpr float mostOdds = 4.F;  //!< A pixel's log-odds are clamped to plus and minus this.

  /*!
    Makes the map of \e frame. Memory is used again: where the last region was as large, nothing is allocated.
    \param histograms What was learnt of the colours; while nothing was, the map is 0.
    \param roi Part of the image, clipped to it and enlarged to whole map pixels; where it is empty, so is the map.
    \throw vpException where the histograms are of colours and the frame is gray.
  */
  void compute(const vpCueFrame &frame, const vpColorHistograms &histograms, const vpImageRegion &roi);

  /*!
    \param u, v Image pixels.
    \return Log-odds of object against background at the map pixel that shows (u, v), [-4, 4]; 0 where that is masked,
    outside the region, or not a number.
  */
  float logOdds(double u, double v) const
  {
    const double x = (u - m_left) * (1. / block);
    const double y = (v - m_top) * (1. / block);
    if (!(x >= 0. && y >= 0. && x < m_columns && y < m_rows)) {
      return 0.F;
    }
    return m_map[static_cast<std::size_t>(y) * m_stride + static_cast<std::size_t>(x)] * (1.F / stepsPerUnit);
  }

  /*!
    The same at places on a line, for loops over many of them.
    \param u, v The first place, image pixels.
    \param du, dv From each place to the next, image pixels.
    \param steps Gets logOdds() of each, times stepsPerUnit.
  */
  template <std::size_t N> void lookUpLine(float u, float v, float du, float dv, std::array<int, N> &steps) const
  {
    const float x = (u - static_cast<float>(m_left)) * (1.F / block);
    const float y = (v - static_cast<float>(m_top)) * (1.F / block);
    const float dx = du * (1.F / block);
    const float dy = dv * (1.F / block);
    const float last = static_cast<float>(N - 1);
    const int stride = static_cast<int>(m_stride);
    if (isInside(x, y) && isInside(x + last * dx, y + last * dy)) { // And so all between.
      for (std::size_t k = 0; k < N; ++k) {
        const float step = static_cast<float>(static_cast<int>(k));
        steps[k] = static_cast<int>(y + step * dy) * stride + static_cast<int>(x + step * dx);
      }
      for (std::size_t k = 0; k < N; ++k) {
        steps[k] = m_map[static_cast<std::size_t>(steps[k])];
      }
      return;
    }
    for (std::size_t k = 0; k < N; ++k) {
      const float atX = x + static_cast<float>(k) * dx;
      const float atY = y + static_cast<float>(k) * dy;
      const int place = isInside(atX, atY) ? static_cast<int>(atY) * stride + static_cast<int>(atX) : -1;
      steps[k] = place < 0 ? 0 : m_map[static_cast<std::size_t>(place)];
    }
  }

  unsigned int width() const { return static_cast<unsigned int>(m_columns); } //!< Of the map, map pixels.
  unsigned int height() const { return static_cast<unsigned int>(m_rows); }   //!< Of the map, map pixels.

  //! Draws the map: gray 128 where nothing is known, brighter for the object. \param I Gets the map's size.
  void draw(vpImage<unsigned char> &I) const;

private:
  // Map pixels.
  bool isInside(float x, float y) const
  {
    return x >= 0.F && y >= 0.F && x < static_cast<float>(m_columns) && y < static_cast<float>(m_rows);
  }
  void fillTable(const vpColorHistograms &histograms);
  void clearMasked(const vpCueFrame &frame);

  double m_left = 0.; // Image pixels: the left and the upper side of the first map pixel.
  double m_top = 0.;
  double m_columns = 0.; // What lookups compare with.
  double m_rows = 0.;
  std::size_t m_stride = 0;
  std::vector<std::int8_t> m_map;
  std::vector<std::int8_t> m_table;  // The steps of each colour of the histograms.
  std::vector<std::uint32_t> m_keys; // Where in the table the pixels of two rows are.
};

END_VISP_NAMESPACE
#endif
