// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFoundPoseTwins_h
#define vpFoundPoseTwins_h

#include "symmetry/vpHalfTurns.h"

#include <algorithm>
#include <cmath>
#include <vector>

BEGIN_VISP_NAMESPACE

//! Poses that may be the right ones instead of the one where the object was found, for some frames.
struct vpFoundPoseTwins
{
  struct Twin
  {
    vpHomogeneousMatrix oMt; //!< From the object's frame at it to that at the pose that is followed.
    double lead = 0.;        //!< Of the followed pose before it, as a logarithm of odds.
  };

  //! Frames in which a twin did not win are enough.
  static constexpr unsigned int mostComparisons = 60;
  //! What a pose a little beside the right one may gain now and then.
  static constexpr double negligibleLead = 4.;

  //! After the object was found at a pose: those turned by half.
  void start(const vpHomogeneousMatrix &cMo, const vpHalfTurns &halfTurns)
  {
    twins.clear();
    frames = 0;
    for (const vpHomogeneousMatrix &turned : halfTurns.turned(cMo)) {
      twins.push_back({cMo.inverse() * turned, 0.});
    }
  }
  void end() { *this = vpFoundPoseTwins(); }
  bool isOver() const { return frames >= mostComparisons; }
  //! Probability of the pose that is followed. The twins count as long as they have more of their own than that.
  double believed(double probability) const
  {
    double least = 0.;
    for (const Twin &twin : twins) {
      least = std::min(least, twin.lead + negligibleLead);
    }
    return probability / (probability + (1. - probability) * std::exp(-least));
  }

  std::vector<Twin> twins;
  unsigned int frames = mostComparisons; //!< In which they were compared.
};

END_VISP_NAMESPACE
#endif
