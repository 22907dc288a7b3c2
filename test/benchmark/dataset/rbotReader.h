// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchRbotReader_h
#define benchRbotReader_h

#include "dataset/sequence.h"

namespace bench {

/*!
  The RBOT data set (Tjaden, Schwanecke, Schoemer and Cremers, *A region-based Gauss-Newton approach to real-time
  monocular multiple object tracking*, TPAMI 2018): per object a folder with its mesh and 1001 images in each of four
  variants; camera and poses are the same for all of them. A scene is "<object>/<variant>", "ape/a_regular" for
  instance.

  The data set has no description of its files. What is known from programs that read it,
  ICG/examples/rbot_evaluator.cpp and .h of the repository DLR-RM/3DObjectTracking first among them:
  - poses_first.txt, and poses_second.txt for the squirrel that hides the object in d_occlusion: a line of titles, then
  a line for each image, the first one being number 0: the rotation row by row and the translation in millimetres,
  object to camera, between tabulators;
  - ape/ape.obj: millimetres;
  - ape/frames/a_regular0000.png: 640 x 512 pixels, without distortion;
  - camera_calibration.txt: a line of titles, then fx, fy, cx, cy, whatever follows them is not used.

  The images were drawn by OpenGL with the projection matrix of src/transformations.cpp of the repository
  henningtjaden/RBOT, which puts cx at cx pixels from the image's border: centres of pixels are at halves there. This
  project has them at integers, so half a pixel is taken off the principal point, as rbot_evaluator.h does.

  How much of the object is visible is not told: 1 everywhere.
*/
namespace rbotReader {
//! True for a folder with one of the files that the data set starts with.
bool isDataset(const std::string &dataset);

//! Sorted; empty where there is none. \throw vpException naming the folder where it is missing.
std::vector<std::string> scenes(const std::string &dataset);

/*!
  Poses of a file such as poses_first.txt; its line of titles may be missing.
  \return cMo, metres; two at least.
  \throw vpException naming the file that cannot be read, and the line that is no pose.
*/
std::vector<vpHomogeneousMatrix> readPoses(const std::string &file);

//! \param scene One of scenes(). \param object 0 or 1. \throw vpException as openSequence().
Sequence open(const std::string &dataset, const std::string &scene, int object);
} // namespace rbotReader

} // namespace bench
#endif
