// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsTrackOptions_h
#define programsTrackOptions_h

#include "frames/frameReader.h"

#include <string>
#include <vector>

namespace programs {

//! Where the object is at first. One of them is given.
struct StartOptions
{
  std::string click;      //!< .init file of 3D points to click on.
  std::string points;     //!< File of 3D points and their places in the first image.
  std::string pose;       //!< File of the pose.
  std::string rough;      //!< File of a pose that is not exact.
  double roughAngle = 15; //!< How far off that one is, degrees.
  double roughOffset = 0; //!< Likewise, metres; 0: a tenth of the model's diameter.
  bool anywhere = false;  //!< Look for the object in all of the image.
  double nearest = 0.;    //!< Least distance at which it may be then, metres; 0: the tracker's default.
  double farthest = 0.;   //!< Likewise the largest one.
  int tag = -1;           //!< Number of an AprilTag (36h11) that is fixed to the object.
  double tagSize = 0.;    //!< Side of its black square, metres.
  std::string tagPose;    //!< File of its pose in the object's frame; empty: it is that frame.
};

//! What the command line says. An empty text is an option that was not given.
struct TrackOptions
{
  FrameSource source;
  std::string model;
  double metresPerUnit = 0.; //!< Unit of a mesh; 0: as the configuration says, or metres.
  std::string config;        //!< Configuration file with the camera's parameters.
  std::string preset;        //!< Name of a preset.
  std::vector<std::string> cues;
  StartOptions start;
  bool gray = false;      //!< Track in gray levels.
  bool noDisplay = false; //!< Open no window.
  bool noPlots = false;   //!< Draw no plots beside the image.
  bool fullSpeed = false; //!< Do not wait for the time of the next frame of a video with a window.
  std::string save;       //!< Video or pattern of image files to write.
  double framesPerSecond = 0.;
  std::string record; //!< Folder of a data set in BOP's layout.
  std::string poses;
  std::string summary;

  //! \return False where --help or --version was asked for and printed. \throw vpException naming the option that is
  //! unknown, missing, or has a wrong value.
  bool read(int argc, const char *const argv[]);

private:
  void check() const;
};

} // namespace programs
#endif
