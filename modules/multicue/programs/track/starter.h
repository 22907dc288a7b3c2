// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsStarter_h
#define programsStarter_h

#include "track/tagFinder.h"
#include "track/trackOptions.h"
#include "track/trackView.h"
#include "track/trackWindow.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <memory>

namespace programs {

/*!
  Starts the tracker in the way that the options name. Each way is one function of this class: another one is an option
  of StartOptions, a function here and a line in start().
*/
class Starter
{
public:
  //! Reads the files that belong to the start. \throw vpException naming the one that is missing or broken.
  Starter(const TrackOptions &options, vpMbMultiCueTracker &tracker);

  /*!
    \param window Null for none.
    \return False where this image does not tell: it shows no tag, the object is not found, or the
    user gave up clicking. The next one may.
    \throw vpException as the tracker's init functions, and where clicks are needed without a window.
  */
  bool start(const vpImage<vpRGBa> &I, TrackWindow *window, const TrackView &view);
  //! When the user asks for it: by clicks, the tag or in all of the image, else about the last pose.
  bool startAgain(const vpImage<vpRGBa> &I, TrackWindow *window, const TrackView &view);

private:
  bool byClicks(const vpImage<vpRGBa> &I, TrackWindow *window, const TrackView &view);
  bool anywhere(const vpImage<vpRGBa> &I);
  bool byTag(const vpImage<vpRGBa> &I);
  bool about(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpPoseDeviation &deviation);

  const TrackOptions &m_options;
  vpMbMultiCueTracker &m_tracker;
  std::vector<vpPoint> m_clickPoints;
  std::shared_ptr<TagFinder> m_tag; //!< The tracker asks it too, when it has lost the object.
};

} // namespace programs
#endif
