// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchStartOptions_h
#define benchStartOptions_h

#include <string>
#include <vector>

namespace bench {

//! What is not there for the tracker to find.
enum class WrongStart
{
  NOTHING, //!< The object is where it is said to be, but for the deviation.
  MODEL,   //!< The model is that of another object.
  SCENE    //!< The image is of a scene with another object.
};

//! How far starts are from the truth.
struct StartDeviation
{
  double angle = 15.;  //!< Of the turn, degrees.
  double offset = 0.1; //!< Of the shift, diameters.
};

//! What multicue-starts is asked to do.
struct StartOptions
{
  std::string dataset;
  std::vector<std::string> scenes;
  std::vector<std::string> trackers;
  std::string config;
  int trials = 200; //!< Of each object, tracker and deviation.
  int seed = 1;
  StartDeviation deviation;
  int frames = 10; //!< That are tracked in each trial.
  WrongStart wrong = WrongStart::NOTHING;
  bool basin = false;
  int threads = 1;
  int jobs = 1;
  std::string out;

  /*!
    \return False where help was asked for and given.
    \throw vpException naming the option that is missing or wrong.
  */
  bool read(int argc, const char *const argv[]);

  //! The deviation that was asked for, or those of the table of --basin.
  std::vector<StartDeviation> deviations() const;

private:
  void setWrong(const std::string &name);
  void check() const;
};

} // namespace bench
#endif
