// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpOrientedDistanceMap_h
#define vpOrientedDistanceMap_h

#include <visp3/cues/vpCueFrame.h>
#include <visp3/cues/vpImageRegion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

BEGIN_VISP_NAMESPACE

class vpMapEdges;

/*!
  \ingroup group_cues_edge
  What counts as an image edge, and how far its distance is told.
*/
struct VISP_EXPORT vpOrientedDistanceSettings
{
  double scale = 0.5;       //!< Map pixels per image pixel: 1, 1 / 2, 1 / 3, ... or 1 / 8.
  double maxDistance = 12.; //!< Greater distances count as this one, image pixels, at least 1; times scale at most 23.
  double contrast =
      5.; //!< Least height of an edge that is sharp in the map, gray levels, [1, 255]; soft ones need more.
  double noiseFactor = 4.;    //!< Least gradient in standard deviations of the frame's own noise, [0, 20]; see \ref
                              //!< cues_distance_edges.
  double clutterFactor = 1.3; //!< Least gradient in mean gradients of what is around, [0, 5]: of a texture only
                              //!< the strongest edges count, and beside it weak ones still do.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_cues_edge
  For each place of a region, and each of eight orientations, the distance to the nearest image edge of about that
  orientation, up to a limit: what the likelihood of many poses asks for at each of their control points ([T10] eq. 11).
  Computed once per frame; lookups may come from several threads. See \ref cues_distance.
*/
class VISP_EXPORT vpOrientedDistanceMap
{
public:
  static constexpr int bins = 8; //!< Orientations, over 180 degrees.

  vpOrientedDistanceMap();
  ~vpOrientedDistanceMap();
  vpOrientedDistanceMap(vpOrientedDistanceMap &&) noexcept;
  vpOrientedDistanceMap &operator=(vpOrientedDistanceMap &&) noexcept;
  vpOrientedDistanceMap(const vpOrientedDistanceMap &) = delete;
  vpOrientedDistanceMap &operator=(const vpOrientedDistanceMap &) = delete;

  //! For the next compute(). \throw vpException as vpOrientedDistanceSettings::check() does.
  void setSettings(const vpOrientedDistanceSettings &settings);
  const vpOrientedDistanceSettings &settings() const { return m_settings; }

  /*!
    Makes the map of \e frame. Masked pixels have no edges. Memory is used again: where the last region was as large,
    nothing is allocated.
    \param roi Part of the image, clipped to it and enlarged to whole map pixels; where it is empty, so is the map.
  */
  void compute(const vpCueFrame &frame, const vpImageRegion &roi);

  /*!
    The bin of edges with normal (\e nx, \e ny), u and v; of any length, and of either sign. Bin k holds the normals
    within 11.25 degrees of k times 22.5 degrees, from the u axis towards the v axis.
  */
  static int bin(double nx, double ny)
  {
    const double x = std::fabs(nx);
    const double y = std::fabs(ny);
    // The tangents of 11.25, 33.75, 56.25 and 78.75 degrees.
    const int steps = (y > 0.19891236737965801 * x) + (y > 0.66817863791929888 * x) + (y > 1.4966057626654890 * x) +
                      (y > 5.0273394921258481 * x);
    return (nx < 0.) == (ny < 0.) ? steps : (bins - steps) & (bins - 1);
  }

  /*!
    \param u, v Image pixels.
    \param bin Of the edge's normal, 0 to 7.
    \return Distance at the map pixel that shows (u, v), image pixels, at most maxDistance, which is also that of
    places outside the region and not a number. An edge of a neighbouring bin is half a map pixel farther away than it
    is.
  */
  double distance(double u, double v, int bin) const
  {
    const double x = (u - m_left) * m_perPixel;
    const double y = (v - m_top) * m_perPixel;
    if (!(x >= 0. && y >= 0. && x < m_columns && y < m_rows)) {
      return m_maxDistance;
    }
    const std::size_t place = static_cast<std::size_t>(y) * m_stride + static_cast<std::size_t>(x);
    return std::min(m_unit * m_inside[place * bins + static_cast<std::size_t>(bin)], m_maxDistance);
  }

  unsigned int width() const { return static_cast<unsigned int>(m_columns); } //!< Of the map, map pixels.
  unsigned int height() const { return static_cast<unsigned int>(m_rows); }   //!< Of the map, map pixels.
  std::size_t edgeCount() const { return m_edgeCount; }                       //!< Edge pixels of the map.
  double threshold() const { return m_threshold; } //!< Least contrast of the last frame's edges, gray levels.

  //! Draws the distances, black 0 and white maxDistance. \param bin Bin, -1 for the least of all. \param I Gets the
  //! map's size.
  void draw(int bin, vpImage<unsigned char> &I) const;

private:
  void clear();

  vpOrientedDistanceSettings m_settings;
  // Image pixels: the left and the upper side of the first map pixel.
  double m_left = 0.;
  double m_top = 0.;
  double m_perPixel = 0.5;
  double m_columns = 0.; // What lookups compare with.
  double m_rows = 0.;
  double m_maxDistance = 12.;
  double m_unit = 0.;                     // Image pixels per step of the map.
  std::size_t m_stride = 0;               // Map pixels from one row to the next.
  const std::uint8_t *m_inside = nullptr; // The first map pixel of the region in m_map, which has a border.
  std::vector<std::uint8_t> m_map;        // Eight bins of one pixel beside each other.
  std::size_t m_edgeCount = 0;
  double m_threshold = 0.;
  std::unique_ptr<vpMapEdges> m_edges;
};

END_VISP_NAMESPACE
#endif
