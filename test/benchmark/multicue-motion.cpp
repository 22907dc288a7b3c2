// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-motion.cpp
  Tells how far an object moves and turns from frame to frame in sequences with ground truth, and how well its motion
  can be predicted.
*/
#include "dataset/motionFigures.h"
#include "dataset/sequence.h"
#include "evaluate/evaluation.h"
#include "program/commandLine.h"
#include "program/runProgram.h"

#include <visp3/core/vpException.h>

#include <cstdio>
#include <iostream>

namespace {
// Poses up to the first frame whose truth is not known: motion is from one frame to the next.
std::vector<vpHomogeneousMatrix> posesOf(const bench::Sequence &sequence, int frames)
{
  std::vector<vpHomogeneousMatrix> poses;
  for (const bench::SequenceFrame &frame : sequence.frames) {
    if (!frame.hasTruth || (frames > 0 && poses.size() == static_cast<std::size_t>(frames))) {
      break;
    }
    poses.push_back(frame.cMo);
  }
  return poses;
}

void print(const bench::Spread &spread)
{
  std::printf(" %.1f (%.1f / %.1f / %.1f) |", spread.mean, spread.tenth, spread.median, spread.ninth);
}

void measure(const bench::Sequence &sequence, int frames)
{
  const std::vector<vpHomogeneousMatrix> poses = posesOf(sequence, frames);
  const bench::MotionFigures figures =
      bench::measureMotion(poses, bench::loadModel(sequence.object)->vertices(), sequence.frames.front().cam);
  std::printf("| %s | %zu |", sequence.scene.c_str(), poses.size());
  print(figures.pixels);
  print(figures.degrees);
  print(figures.prediction);
  std::printf("\n");
}
} // namespace

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] {
    std::string dataset;
    std::vector<std::string> scenes;
    int frames = 0;
    programs::CommandLine line(
        "Tells how far an object moves and turns from frame to frame, and how far off a prediction "
        "with\nconstant velocity is: mean (10 % / median / 90 %) over the frames.\n\n"
        "A data set in BOP's or RBOT's layout:  --dataset DIR --scene NAME");
    line.add("--dataset", "folder of the data set", dataset);
    line.add("--scene", "scenes, separated by commas, or 'all'", scenes);
    line.add("--frames", "only that many frames of each scene", frames, 3);
    if (!line.read(argc, argv)) {
      return 0;
    }
    if (dataset.empty() || scenes.empty()) {
      throw vpException(vpException::badValue, "--dataset and --scene are needed; --help says more");
    }
    std::cout << "| scene | frames | motion, px | turn, degrees | prediction off by, px |\n|---|---|---|---|---|"
              << std::endl;
    for (const std::string &scene : scenes.size() == 1 && scenes[0] == "all" ? bench::listScenes(dataset) : scenes) {
      measure(bench::openSequence(dataset, scene), frames);
    }
    return 0;
  });
}
