// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef frameReader_h
#define frameReader_h

#include "trackerOptions.h"

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include <memory>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! Frames of a video, of image files or of a camera, one after the other.
class FrameReader
{
public:
  virtual ~FrameReader() = default;

  //! \return False at the end, with the image left as it was.
  virtual bool next(vpImage<vpRGBa> &I) = 0;

  //! \return The number of the frame that next() gave.
  int number() const { return m_number; }

  //! \return The number of the last frame, -1 where it is not known.
  virtual int last() const = 0;

  //! \return Frames per second, 0 where they are not known.
  virtual double framesPerSecond() const { return 0.; }

protected:
  int m_number = -1; //!< Of the frame that was read last.
};

/*!
  \return The frames that the options ask for.
  \throw vpException naming what cannot be opened.
*/
std::unique_ptr<FrameReader> openFrames(const TrackerOptions &options);

#endif
