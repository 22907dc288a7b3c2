// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpColorCue_h
#define vpColorCue_h

#include <visp3/cues/vpColorCueSettings.h>
#include <visp3/cues/vpColorHistograms.h>
#include <visp3/cues/vpColorMemory.h>
#include <visp3/cues/vpPoseCue.h>
#include <visp3/se3/vpExactNumber.h>

#include <array>
#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

class vpContourShift;

/*!
  \ingroup group_cues_color
  Separation of the object's colours from the background's along the silhouette ([P14] III-B), coarse to fine.

  Lines are laid across the contour at silhouette points, each as far as nothing covers it. On the coarse levels
  histograms of the whole silhouette say of each pixel which side it belongs to, and each line gives the place of the
  contour with its variance, as region trackers do; that reaches far. On the fine levels, the paper's local means and
  covariances of both sides give the residuals ([P14] eq. 8). Histograms and the temporal consistency's colours are
  learnt by updateReference(); the first match() after reset() takes the view's pose for the true one and learns the
  histograms from it.

  Errors are in standard deviations, so vpResidualBlock::noise is 1. A line whose contour is known to 0.5 pixels and
  which is 1 pixel off has error 2. See \ref cues_color.

  What it costs: match() reads the pixels and computes the statistics; residuals() reads no image.
*/
class VISP_EXPORT vpColorCue : public vpPoseCue
{
public:
  //! A line across the contour. Offsets are along the normal, from the point outwards.
  struct Line
  {
    Eigen::Vector3d position; //!< Of the silhouette point, object frame, metres.
    Eigen::Vector2d pixel;    //!< Its projection in the matched view, pixels.
    Eigen::Vector2d normal;   //!< Unit outward normal there, pixels.
    int first = 0;            //!< Offset of the first pixel of the line that may be used, <= 0.
    int last = 0;             //!< Offset of the last one, >= 0.
    int sampleFirst = 0;      //!< Fine levels: index of its first pixel near the contour.
    int sampleCount = 0;      //!< Fine levels: their number.
    double evidence = 0.;     //!< Coarse levels: see vpColorCue::evidence().
    double light = 1.;        //!< Coarse levels: how well the contour can be seen there, [0, 1].
    double offset = 0.;       //!< Coarse levels: where the contour seems to be, pixels.
    double scale = 0.;        //!< Coarse levels: errors per pixel of the contour's distance. Fine levels: errors are
                              //!< multiplied by this, so that no line claims to know its contour too well.
  };

  explicit vpColorCue(const vpColorCueSettings &settings = vpColorCueSettings());

  //! Also resets and goes to the finest level. \throw vpException naming the member that is out of range; the old
  //! settings then stay.
  void setSettings(const vpColorCueSettings &settings);
  const vpColorCueSettings &settings() const { return m_settings; }

  unsigned int levels() const override;
  //! Without a call, the finest one is used.
  void setLevel(unsigned int level) override;
  unsigned int level() const { return m_level; }

  void match(const vpCueFrame &frame, const vpModelView &view) override;
  //! In the order of lines(): one row each, or for vpColorCueSettings::PIXELS on a fine level one for each of its
  //! pixels and channels.
  void residuals(const vpHomogeneousMatrix &cMo, vpResidualBlock &block) const override;
  void updateReference(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights) override;
  void reset() override;
  void getFeatures(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights,
                   std::vector<vpCueFeature> &features) const override;

  //! The lines of the last match.
  const std::vector<Line> &lines() const { return m_lines; }
  /*!
    How well the view of the last match explains the image's colours; coarse levels only.
    \return Mean over the lines that have light (\ref cues_color_light) of the logarithm of how much likelier the
    contour is where the view has it than anywhere within reach: 0 where the colours tell nothing, about 1 to 1.5 where
    all is well, negative at a wrong pose.
  */
  double evidence() const;
  /*!
    Likewise for another pose near the view's, at the finest of the coarse levels; after a match on a fine level.
    \return 0 where there are no coarse levels.
  */
  double evidenceAt(const vpHomogeneousMatrix &cMo);
  const vpColorHistograms &histograms() const { return m_histograms; }

  //! What trusted frames told.
  struct Reference
  {
    vpColorHistograms histograms;
    vpColorMemory memory;
  };
  Reference reference() const { return {m_histograms, m_memory}; }
  //! Goes back to what was known before. Nothing happens where that was told by gray images and the last one had
  //! colour, or the other way round.
  void setReference(const Reference &reference);

private:
  friend class vpColorLineFinder;
  friend class vpContourBars;
  friend class vpContourPosterior;
  template <int N> friend class vpFineMatch;

  // A pixel of a line on the fine levels: e = b + a(t) d with whitened colours b = C (I_B - I) and d = C (I_O - I_B).
  struct Sample
  {
    double t = 0.;  // Offset of the pixel's centre in the matched view, pixels.
    double bd = 0.; // b . d
    double dd = 0.; // d . d
  };
  struct WhitenedColors
  {
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    Eigen::Vector3d d = Eigen::Vector3d::Zero();
  };

  // A line that something is learnt from, and where the contour of the trusted pose is on it.
  struct Lesson
  {
    std::size_t line;
    int shift; // Pixels.
  };

  // Short straight bars of the silhouette that are next to each other, all within radius of the middle.
  struct BarBlock
  {
    static constexpr std::size_t lanes = 8;
    using Lanes = std::array<float, lanes>;
    Lanes x{}, y{}, tangentX{}, tangentY{}, half{}; // Centre, direction, half length: pixels.
    float middleX = 0.F, middleY = 0.F, radius = 0.F;
    std::size_t count = 0;
  };

  bool isCoarse() const { return m_level < m_settings.scales.size(); }
  double band() const { return m_settings.bands[m_level - m_settings.scales.size()]; }
  bool hasRowPerPixel() const { return !isCoarseMatch() && m_settings.rows == vpColorCueSettings::PIXELS; }
  bool isCoarseMatch() const { return vpIsZero(m_matchedBand); }
  std::size_t rowsOf(const Line &line) const;
  // Pixels of a line: strip(i)[offset].
  const std::uint32_t *strip(std::size_t line) const
  {
    return m_pixels.data() + line * static_cast<std::size_t>(2 * m_reach + 1) + m_reach;
  }
  void setLineRow(const Line &line, const vpContourShift &shift, vpResidual &row) const;
  void setPixelRows(const Line &line, const vpContourShift &shift, vpResidual *rows) const;
  double weightOf(const Line &line, const double *weights) const;
  void findLessons(const vpHomogeneousMatrix &cMo, const std::vector<double> &weights);
  void learnHistograms(double rate);
  void doubtLine(Line &line) const;
  double lightAt(const std::uint32_t *pixels, const Line &line) const;

  vpColorCueSettings m_settings;
  unsigned int m_level = 0;
  vpCameraParameters m_camera;
  unsigned int m_channels = 3;
  int m_reach = 0;           // Pixels of each line to both sides of its point.
  double m_matchedBand = 0.; // Of the last match, 0 where that was a coarse one.
  std::vector<Line> m_lines;
  std::vector<std::uint32_t> m_pixels;
  std::vector<Sample> m_samples;
  std::vector<WhitenedColors> m_whitened; // Of the samples, where each gives rows.
  std::vector<BarBlock> m_bars;           // Scratch of match().
  std::vector<Lesson> m_lessons;          // Scratch of updateReference().
  std::vector<double> m_evidence;         // Of each line at the pose of the last evidenceAt().
  vpColorHistograms m_histograms;
  vpColorMemory m_memory;
};

END_VISP_NAMESPACE
#endif
