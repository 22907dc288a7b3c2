// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchDisturbOptions_h
#define benchDisturbOptions_h

#include "dataset/sequence.h"

namespace bench {

//! What multicue-disturb is asked to do.
struct DisturbOptions
{
  std::string dataset;
  std::string scene;
  std::string images; //!< In place of dataset and scene: printf pattern, or a video.
  int first = -1;
  int last = -1;     //!< -1: as many as there are.
  std::string poses; //!< printf pattern of true poses, as text files of 16 numbers.
  std::string start; //!< In place of them: file of the first pose, 6 numbers as ViSP's .pos files have.
  //! Trackers that then give the poses to compare with: those of the first, where all agree.
  std::vector<std::string> followers = {"visp-edge", "multicue"};
  std::string model;
  double unit = 1.;
  std::string config;
  std::vector<std::string> trackers;
  std::vector<int> offsets = {2, 4, 6, 10}; //!< Of the starts, pixels; mean over the model's points.
  std::vector<int> shifts = {20, 26, 32, 40, 52, 68, 86, 105, 126}; //!< Of the images, pixels.
  int trials = 100;                                                 //!< Of each offset.
  int frames = 10;                                                  //!< That a start is followed for.
  int framesAfter = 5;                                              //!< That a shift is followed for.
  double right = 2.5; //!< Pixels that the model's points may be off in the end, in the mean.
  bool gray = false;
  int seed = 1;

  /*!
    \return False where help was asked for and given.
    \throw vpException naming the option that is missing or wrong.
  */
  bool read(int argc, const char *const argv[]);

private:
  void check() const;
};

} // namespace bench
#endif
