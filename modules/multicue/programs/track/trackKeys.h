// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsTrackKeys_h
#define programsTrackKeys_h

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <string>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! What the keys of the window change.
struct ViewState
{
  bool quit = false;
  bool paused = false;
  bool step = false;       //!< One more frame while paused.
  bool restart = false;    //!< The user asks for a new start.
  bool features = true;    //!< Draw the features.
  bool hypotheses = false; //!< Draw the poses that the image allows.
  bool particles = false;  //!< Draw the particles.
  std::string message;     //!< What the last key did, for the picture.
};

//! Lines of text that tell the keys.
std::string keysHelp();

/*!
  Does what a key stands for; nothing for others.
  \param key As vpDisplay::getKeyboardEvent() gives it.
*/
void applyKey(const std::string &key, vpMbMultiCueTracker &tracker, ViewState &view);

} // namespace programs
#endif
