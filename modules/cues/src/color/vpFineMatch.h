// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFineMatch_h
#define vpFineMatch_h

#include "color/vpLocalStatistics.h"

BEGIN_VISP_NAMESPACE

/*!
  Turns the pixels of lines into samples, with the local statistics of both sides; covariances and so the whitening
  are those at the matched view's pose until the next match.
*/
template <int N> class vpFineMatch
{
public:
  explicit vpFineMatch(vpColorCue &cue) : m_cue(cue), m_band(cue.band()) {}

  //! Fills the samples of all lines.
  void run();

private:
  using Statistics = vpLocalStatistics<N>;
  using Vector = typename Statistics::Vector;
  using Matrix = typename Statistics::Matrix;

  //! Means (I_O, I_B) and covariances (R_O, R_B) of a line.
  struct Sides
  {
    Vector object, background;
    Matrix objectSpread, backgroundSpread;
  };

  Sides sidesOf(std::size_t index) const;
  void blend(const Vector &before, const Matrix &spread, Vector &mean) const;
  void addSamples(std::size_t index, const Sides &sides);
  void addSample(double t, double a, const Vector &color, const Sides &sides);

  vpColorCue &m_cue;
  double m_band;
};

END_VISP_NAMESPACE
#endif
