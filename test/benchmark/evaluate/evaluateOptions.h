// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchEvaluateOptions_h
#define benchEvaluateOptions_h

#include "dataset/sequence.h"
#include "evaluate/protocol.h"
#include "evaluate/startPoses.h"

namespace bench {

//! What multicue-evaluate is asked to do.
struct EvaluateOptions
{
  std::string dataset;
  std::vector<std::string> scenes;
  int object = 0;      //!< 0: the first one of the scene.
  Recording recording; //!< In place of dataset and scenes, where its images are named.
  std::vector<std::string> trackers;
  std::vector<Protocol> protocols = {Protocol::RBOT};
  std::vector<int> steps = {1};
  std::string config;
  std::vector<std::string> cues; //!< Of our trackers; none: as they have them.
  int threads = 1;
  int jobs = 1;
  StartPoses start;
  int frames = 0; //!< Of each sequence; 0: all.
  bool resume = false;
  std::string out;

  /*!
    \return False where help was asked for and given.
    \throw vpException naming the option that is missing or wrong.
  */
  bool read(int argc, const char *const argv[]);

  bool hasRecording() const { return !recording.images.empty(); }

private:
  void setProtocols(const std::string &name);
  void check() const;
};

} // namespace bench
#endif
