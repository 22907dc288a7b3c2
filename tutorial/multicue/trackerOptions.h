// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef trackerOptions_h
#define trackerOptions_h

#include <string>

//! What the command line says. An empty text is an option that was not given.
struct TrackerOptions
{
  std::string images;         //!< Pattern of image files, one of images, video and camera.
  std::string video;          //!< Video file.
  int camera = -1;            //!< Index of a camera, >= 0.
  std::string model;          //!< Model file.
  double metresPerUnit = 1.;  //!< Unit of a mesh.
  std::string config;         //!< Configuration file with the camera's parameters.
  std::string initClick;      //!< File with 3D points to click on, one of the three init options.
  std::string initPose;       //!< File with a pose.
  std::string initPoints;     //!< File with 3D points and their places in the image.
  bool color = false;         //!< Track in colour.
  bool display = true;        //!< Open a window where there is a display.
  std::string save;           //!< Video or pattern of image files to write.
  std::string poses;          //!< CSV file to write.
  std::string summary;        //!< Text file to write.
  int first = -1;             //!< Number of the first frame, -1 for the first that there is.
  int last = -1;              //!< Number of the last frame, -1 for the last that there is.
  int step = 1;               //!< 2 takes every second frame, > 0.
  double framesPerSecond = 0; //!< Of the saved video, 0 for that of the source.
  bool help = false;          //!< Print the options and do nothing.
};

/*!
  \return The options of the command line.
  \throw vpException naming the option that is unknown, missing, or has a wrong value.
*/
TrackerOptions readOptions(int argc, const char *const argv[]);

//! \return The text of --help.
std::string helpText();

#endif
