// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpStartEvidence_h
#define vpStartEvidence_h

#include "search/vpStartSearch.h"

#include <string>

BEGIN_VISP_NAMESPACE

/*
  What speaks for a pose of which nothing was known beforehand, over one image or several: by how much it is better than
  what the same search finds elsewhere in these images, and how much of what the tracker looks for it finds there.
*/
class vpStartEvidence
{
public:
  // What the cues find at the pose.
  struct Support
  {
    double edges = 0.; // Agreement of the control points, about 1 where all are found.
    bool hasEdges = false;
    double colors = 0.; // Separation of the colours across the silhouette, 1 and more where they differ.
    bool hasColors = false;
  };

  void clear() { *this = vpStartEvidence(); }
  // In how many images the object was looked for: the more often, the likelier one of them deceives.
  void setTries(unsigned int tries) { m_tries = tries; }
  // Of the same pose in one more image in which it was looked for.
  void noteFoundAgain() { ++m_again; }
  // Of one more image. trust: of the model's colours, see vpStartSearch.
  void add(const vpStartSearch::Value &value, const std::vector<vpStartSearch::Value> &clutter, const Support &support,
           double trust);
  std::size_t frames() const { return m_frames; }
  // By how many deviations the pose is better than the best ones elsewhere.
  double advantage() const;
  // strict: of the share that is needed in the end; below 1 for a first look.
  bool isEnough(double strict) const;
  // What is missing, or that nothing is.
  std::string text(double strict) const;

private:
  double mean(double sum) const { return m_frames > 0 ? sum / static_cast<double>(m_frames) : 0.; }
  double neededAdvantage() const;
  double neededModelColors() const;
  // Images in which the object was looked for in vain, up to a number.
  double triesBefore() const;

  unsigned int m_tries = 1;
  unsigned int m_again = 0;
  std::size_t m_frames = 0;
  double m_total = 0.;
  double m_modelColors = 0.;
  double m_trust = 0.;
  Support m_support; // Sums.
  std::size_t m_places = 0;
  double m_clutter = 0.; // Sums over the places.
  double m_clutterSquares = 0.;
};

END_VISP_NAMESPACE
#endif
