// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpAgreement_h
#define vpAgreement_h

#include "cues/vpCueSet.h"

#include <cmath>

BEGIN_VISP_NAMESPACE

//! How well each cue agrees with a pose; about 1 for colours, and below 1 for the others, where all is well.
struct vpAgreement
{
  vpCueValues cues;
  //! Mean distance to the edges of the image ([T10] eq. 11), for edges alone; 1 is the largest.
  double mapDistance = 0.;
  double evidence = 0.;  //!< See vpEdgeCue::evidence(), for edges alone.
  double edgeCount = 0.; //!< How many there are to agree with.
  double surface = 0.;
  double surfaceKnown = 0.;  //!< Share of it that is remembered.
  double surfaceWeight = 0.; //!< Share of it that is remembered and tells poses apart.
  double surfaceOdds = 0.;   //!< What it adds to those of all cues together, as a logarithm.
  //! After a loss: the surface looks so different that the pose can hardly be right.
  bool isRefuted = false;
};

//! What the cues say of a pose, as shares of what they had at trusted ones.
struct vpCueShare
{
  double sum = 0.;
  double cues = 0.;       //!< Their weights.
  double most = HUGE_VAL; //!< That the others are worth beside the edges.
};

//! What an image says of a pose.
struct vpVerdict
{
  vpAgreement agreement;
  vpCueShare share;
  double explained =
      -1.; //!< Of what trusted poses had, about 1 where all is well; less than any pose's where none was.
};

END_VISP_NAMESPACE
#endif
