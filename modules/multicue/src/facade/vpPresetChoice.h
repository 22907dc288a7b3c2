// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPresetChoice_h
#define vpPresetChoice_h

#include <visp3/multicue/vpMultiCuePreset.h>

#include <optional>

BEGIN_VISP_NAMESPACE

//! Which preset a tracker has, and whether anybody asked for it.
struct vpPresetChoice
{
  std::optional<vpMultiCuePreset> preset; //!< The last one; none once cues were chosen.
  bool isAssumed = false;                 //!< It is the default constructor's: nobody asked for it.
  // Of such a preset, what was asked for since, and stays where it gives way.
  bool keepsPrediction = false;
  bool keepsSearch = false;
  bool keepsDeadline = false;

  //! Cues were chosen. An assumed preset gives way to them: what it had switched on is switched off.
  void takeCues(bool &predicts, bool &searches, double &deadline)
  {
    if (isAssumed) {
      predicts = predicts && keepsPrediction;
      searches = searches && keepsSearch;
      deadline = keepsDeadline ? deadline : 0.;
    }
    *this = vpPresetChoice();
  }
};

END_VISP_NAMESPACE
#endif
