// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpRoughStart_h
#define vpRoughStart_h

#include "search/vpImageSearch.h"
#include "search/vpStartEvidence.h"

#include <visp3/multicue/vpWeightedPose.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

// Poses that came from outside and are not exact, and a start from them until it is confirmed.
struct vpRoughStart
{
  enum Phase
  {
    NONE,       // There was no such start, or it was confirmed.
    REFUSED,    // None of the poses was accepted.
    UNCONFIRMED // One was, and has to explain more frames.
  };

  // Along each axis, of deviations of the whole motion; somewhat more than by the root of 3.
  static vpPoseSearch::Spread spreadOf(const vpPoseDeviation &deviation, double diameter)
  {
    const double perAxis = 0.8;
    const double usualTranslation = 0.1; // Diameters.
    const double translation = deviation.translation > 0. ? deviation.translation / diameter : usualTranslation;
    return {perAxis * translation, perAxis * deviation.rotation, perAxis * translation};
  }

  static const vpHomogeneousMatrix &heaviest(const std::vector<vpWeightedPose> &poses)
  {
    return std::max_element(poses.begin(), poses.end(),
                            [](const vpWeightedPose &a, const vpWeightedPose &b) { return a.weight < b.weight; })
        ->cMo;
  }

  void clear()
  {
    phase = NONE;
    candidates.clear();
    anywhere.reset();
    evidence.clear();
    tries = 0;
    depths.clear();
  }

  Phase phase = NONE;
  std::vector<vpWeightedPose> candidates;
  std::optional<vpImageSearch::Sizes> anywhere; // Without candidates: in all of the image.
  vpPoseSearch::Spread spread;                  // About them.
  unsigned int tries = 0;                       // Images in which the object was looked for about them.
  vpHomogeneousMatrix refused;                  // Of the image before, cMb with b at the object's middle.
  vpStartSearch search;
  vpImageSearch imageSearch;
  vpStartEvidence evidence;

  vpPoseDetector detector;
  std::vector<vpWeightedPose> detected; // In this frame.
  std::string detectorText;             // What was wrong with it in this frame.
  std::vector<double> depths;           // Of what it or a hint gave last since the object was trusted, metres.

  bool hasHint = false;
  vpHomogeneousMatrix hint;
  vpPoseDeviation hintDeviation;
};

END_VISP_NAMESPACE
#endif
