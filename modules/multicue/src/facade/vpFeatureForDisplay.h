// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpFeatureForDisplay_h
#define vpFeatureForDisplay_h

#include <visp3/core/vpImagePoint.h>
#include <visp3/cues/vpPoseCue.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

BEGIN_VISP_NAMESPACE

//! A feature in the image as it was taken.
struct vpMbMultiCueTracker::Feature
{
  vpImagePoint place;
  vpFeatureState state = vpFeatureState::GOOD;
  int id = -1; //!< Of a point; -1 for other features.
};

END_VISP_NAMESPACE
#endif
