// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpColorCueSettings_h
#define vpColorCueSettings_h

#include <visp3/se3/vpCompatibility.h>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_cues_color
  How object and background are told apart by their colours.
*/
struct VISP_EXPORT vpColorCueSettings
{
  //! What one equation stands for on the fine levels.
  enum Rows
  {
    LINES, //!< One row for each line across the contour: the same normal equations as PIXELS, in a thirtieth of the
           //!< rows, and a robust estimator judges a control point as a whole, as [P14] eq. 9 does.
    PIXELS //!< One row for each pixel and channel, [P14] eq. 8.
  };

  double spacing = 4.;      //!< Least distance of lines along the contour, pixels, [1, 100].
  unsigned int lines = 200; //!< Most lines, [10, 5000]; where there are more, they are spread farther apart.

  std::vector<unsigned int> scales = {6, 3,
                                      2}; //!< Coarse levels, histograms of the whole silhouette: pixels that are
                                          //!< taken together along a line, falling, [1, 20] each; the search
                                          //!< reaches 6 times as far to both sides. At most 8, none: no such level.
  std::vector<double> bands = {1.5, 0.8}; //!< Fine levels, local statistics: s of the membership, pixels, falling,
                                          //!< [0.5, 20] each; 1 to 8 levels.
  double length = 6.; //!< L: the statistics' pixels are up to that far from the contour, pixels, [3, 60].
  double alpha = 0.5; //!< Share of the current frame's colours in I^; the rest is the last trusted one's, (0, 1].
  double regularisation = 8.;    //!< Standard deviation added to each channel's, gray levels, [1, 100].
  double contourDeviation = 0.3; //!< How well the model's contour is known even where all is well, pixels, [0.05, 5].

  double histogramLength = 18.; //!< The histograms' pixels are up to that far from the contour, pixels, [3, 60].
  double learningRate = 0.2;    //!< Share of a new trusted frame in the histograms, [0, 1].
  Rows rows = LINES;            //!< What one row stands for on the fine levels.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

END_VISP_NAMESPACE
#endif
