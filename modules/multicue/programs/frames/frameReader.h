// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsFrameReader_h
#define programsFrameReader_h

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include <memory>
#include <string>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! Where frames come from: one of images, video and camera.
struct FrameSource
{
  std::string images; //!< Pattern of image files.
  std::string video;  //!< Video file, or any address that OpenCV opens.
  int camera = -1;    //!< Index of a camera, >= 0.
  int first = -1;     //!< Number of the first frame, -1 for the first that there is.
  int last = -1;      //!< Number of the last frame, -1 for the last that there is.
  int step = 1;       //!< From one frame to the next: 2 takes every second one, > 0.
};

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
  \return The frames that are asked for.
  \throw vpException naming what cannot be opened.
*/
std::unique_ptr<FrameReader> openFrames(const FrameSource &source);

} // namespace programs
#endif
