// SPDX-License-Identifier: GPL-2.0-or-later
/*!
  \file multicue-demo.cpp
  ViSP's tracker and ours on the same images, side by side in one video, and who held how long. Run by ./demo.
*/
#include "demo/demoPicture.h"
#include "frames/frameReader.h"
#include "frames/videoFile.h"
#include "program/commandLine.h"
#include "program/runProgram.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpWholeFile.h>

#include <opencv2/imgproc.hpp>

#include <iostream>

namespace {
using programs::DemoRecord;
using programs::DemoSequence;
using programs::DemoTracker;

const double framesPerSecond = 25.;
const int summaryFrames = 100; // Time to read it.

struct Options
{
  std::string images;
  std::string data;
  std::string save;
  std::string summary;
  int sequence = 0;  //!< Only that one; 0 for all.
  double scale = 1.; //!< Of the pictures that are written.
};

// Writes pictures one after the other, numbered over all sequences.
class Film
{
public:
  Film(const std::string &file, double scale) : m_video("--save", file, framesPerSecond), m_scale(scale) {}

  void add(const cv::Mat &picture)
  {
    cv::Mat scaled;
    cv::resize(picture, scaled, cv::Size(), m_scale, m_scale, cv::INTER_AREA);
    m_video.write(scaled, m_count++);
  }
  const std::string &file() const { return m_video.file(); }

private:
  programs::VideoFile m_video;
  double m_scale;
  int m_count = 0;
};

std::string figures(const DemoRecord &record)
{
  std::string text = "  " + record.tracker() + "\n";
  for (const std::string &line : record.summary()) {
    text += "    " + line + "\n";
  }
  return text;
}

std::string show(const DemoSequence &sequence, Film &film)
{
  programs::FrameSource source;
  source.images = sequence.images;
  const std::unique_ptr<programs::FrameReader> frames = programs::openFrames(source);
  const std::unique_ptr<DemoTracker> trackers[] = {programs::makeVispTracker(sequence),
                                                   programs::makeMultiCueTracker(sequence)};
  DemoRecord records[] = {{sequence, trackers[0]->name()}, {sequence, trackers[1]->name()}};
  const bool hasTruth = !sequence.truth.empty();
  cv::Mat picture;
  vpImage<vpRGBa> I;
  for (bool isFirst = true; frames->next(I); isFirst = false) {
    cv::Mat halves[2];
    for (std::size_t i = 0; i < 2; ++i) {
      DemoTracker &tracker = *trackers[i];
      if (isFirst) {
        tracker.start(I, sequence.start);
      }
      const programs::DemoAnswer answer = tracker.track(I);
      const double error = hasTruth ? 0. : tracker.projectionError(I, answer.cMo);
      const DemoRecord::Frame &frame = records[i].add(frames->number(), answer, error);
      halves[i] = programs::demoHalf(I, tracker, answer, frame, hasTruth);
    }
    picture = programs::demoPicture(sequence.title, halves[0], halves[1]);
    film.add(picture);
  }
  const cv::Mat summary = programs::demoSummary(sequence.title, records[0], records[1], picture.size());
  for (int i = 0; i < summaryFrames; ++i) {
    film.add(summary);
  }
  return sequence.title + "\n" + figures(records[0]) + figures(records[1]);
}

void run(const Options &options)
{
  Film film(options.save, options.scale);
  std::string text;
  int number = 0;
  for (const DemoSequence &sequence : programs::demoSequences(options.images, options.data)) {
    if (++number == options.sequence || options.sequence == 0) {
      text += show(sequence, film) + "\n";
    }
  }
  std::cout << text << "saved: " << film.file() << std::endl;
  if (!options.summary.empty()) {
    vpWholeFile::write(options.summary, text);
  }
}
} // namespace

int main(int argc, const char *argv[])
{
  return programs::runProgram([&] {
    Options options;
    programs::CommandLine line("Shows ViSP's tracker and ours on the same images, side by side in one video.");
    line.add("--images", "folder of ViSP's images", options.images);
    line.add("--data", "the project's folder data", options.data);
    line.add("--save", "video or pattern of image files to write", options.save);
    line.add("--summary", "text file to write the figures into", options.summary);
    line.add("--sequence", "only that one: 1 or 2", options.sequence, 1);
    line.add("--scale", "of the pictures that are written; default 1", options.scale);
    if (line.read(argc, argv)) {
      if (options.save.empty() || options.images.empty() || options.data.empty()) {
        throw vpException(vpException::badValue, "--images, --data and --save are needed");
      }
      if (!(options.scale >= 0.1 && options.scale <= 4.)) {
        throw vpException(vpException::badValue, "--scale is from 0.1 to 4");
      }
      run(options);
    }
    return 0;
  });
}
