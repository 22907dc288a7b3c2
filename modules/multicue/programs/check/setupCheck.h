// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsSetupCheck_h
#define programsSetupCheck_h

#include "check/checkReport.h"

namespace programs {

//! What is to be tracked, how, and from where.
struct Setup
{
  std::string model;         //!< Path; empty: the one that the configuration says.
  double metresPerUnit = 1.; //!< Of a mesh file.
  std::string config;        //!< Path of a configuration or of a camera's calibration.
  std::string image;         //!< Path of the first image; empty: none.
  std::string video;         //!< Path of the video, where there is no image: its first one is taken; empty: none.
  std::string pose;          //!< Path of the start pose in it; empty: none.
  std::string overlay;       //!< Path of the picture to write; empty: none. Without a pose it is the image alone.
};

/*!
  Looks for what keeps an object from being tracked, before it is tried: model, camera, image, start pose, renderer, and
  what of the object each cue can use. Never throws because of what is wrong with the set-up.
*/
CheckReport checkSetup(const Setup &setup);

} // namespace programs
#endif
