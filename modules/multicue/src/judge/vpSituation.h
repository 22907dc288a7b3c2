// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSituation_h
#define vpSituation_h

#include "judge/vpPoseBelief.h"
#include "judge/vpPoseTracks.h"

BEGIN_VISP_NAMESPACE

//! Whether the object is followed, or was lost and has to be found and confirmed; kept up to date by vpLossWatch.
struct vpSituation
{
  bool mustConfirm = false;         //!< It was lost, and no pose found since is confirmed.
  unsigned int framesSinceLoss = 0; //!< While it has to be confirmed; 0 before the first frame.
  unsigned int confirmations = 0;   //!< Frames that explained a pose on end since the object was lost.
  unsigned int trustedFrames = 0;   //!< Since the start, or since the object was found again.
  // On end:
  unsigned int outsideFrames = 0;     //!< Hardly any of the object is in the image.
  unsigned int doubtfulFrames = 0;    //!< The same, with a pose that is not explained.
  unsigned int disbelievedFrames = 0; //!< The pose is hardly believed.
  bool wasSudden = false;             //!< The last loss.
  bool wasFound = false;              //!< After a loss.
  bool wasTracking = false;           //!< In the frame before.
  vpPoseTracks tracks;                //!< While it has to be confirmed.
  vpPoseBelief belief;                //!< Of several cues.
  //! Likely poses of the frames before, while the object is looked for everywhere.
  std::vector<vpHomogeneousMatrix> searched;
};

END_VISP_NAMESPACE
#endif
