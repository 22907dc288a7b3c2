// SPDX-License-Identifier: GPL-2.0-or-later
#include "disturb/footage.h"

#include "dataset/checkedGeometry.h"
#include "dataset/datasetFiles.h"
#include "evaluate/evaluation.h"
#include "evaluate/imageStore.h"
#include "evaluate/poseError.h"
#include "frames/frameReader.h"
#include "track/startFiles.h"

#include <visp3/core/vpImageConvert.h>
#include <visp3/model/vpModelReader.h>
#include <visp3/multicue/vpMultiCueSettings.h>

namespace bench {

namespace {
const double wellVisible = 0.8; // Share of the silhouette, of a frame that is used.
// Of the pixels that a right pose may be off: as far as followers agree.
const double agreeingShare = 0.75;

void openScene(const DisturbOptions &options, Footage &footage)
{
  const Sequence sequence = openSequence(options.dataset, options.scene);
  footage.object = sequence.object;
  footage.cam = sequence.frames.front().cam;
  ImageStore store(sequence);
  for (std::size_t i = 0; i < sequence.frames.size(); ++i) {
    const SequenceFrame &frame = sequence.frames[i];
    footage.images.emplace_back();
    store.get(i, footage.images.back());
    footage.truth.push_back(frame.cMo);
    footage.isSeen.push_back(frame.hasTruth && frame.visibility >= wellVisible);
  }
}

// \return The number of each image.
std::vector<int> readImages(const DisturbOptions &options, Footage &footage)
{
  programs::FrameSource source;
  const bool isVideo = options.images.find('%') == std::string::npos;
  (isVideo ? source.video : source.images) = options.images;
  source.first = options.first;
  source.last = options.last;
  const std::unique_ptr<programs::FrameReader> reader = programs::openFrames(source);
  std::vector<int> numbers;
  for (vpImage<vpRGBa> I; reader->next(I);) {
    footage.images.emplace_back();
    footage.images.back().color = I;
    vpImageConvert::convert(I, footage.images.back().gray);
    numbers.push_back(reader->number());
  }
  return numbers;
}

// Where the followers have the object.
void followTruth(const DisturbOptions &options, Footage &footage)
{
  const vpHomogeneousMatrix start = programs::readPose(options.start);
  const PoseErrorMeasure measure(footage.object, *footage.model);
  footage.isSeen.assign(footage.images.size(), true);
  for (const std::string &name : options.followers) {
    const std::unique_ptr<BenchTracker> tracker = makeTracker(name, footage.object, footage.cam, options.config);
    tracker->init(footage.images.front(), start);
    const bool isFirst = footage.truth.empty();
    for (std::size_t i = 0; i < footage.images.size(); ++i) {
      tracker->track(footage.images[i]);
      const TrackerAnswer answer = tracker->answer();
      if (footage.truth.size() == i) {
        footage.truth.push_back(answer.cMo);
      }
      const bool agrees =
          isFirst || measure(answer.cMo, footage.truth[i], footage.cam).pixels < agreeingShare * options.right;
      footage.isSeen[i] = footage.isSeen[i] && answer.state == vpTrackingState::TRACKING && agrees;
    }
  }
}

void openRecordedImages(const DisturbOptions &options, Footage &footage)
{
  requireFile(options.model, "it is the object's model");
  if (vpModelReader::isMesh(options.model)) {
    footage.object.mesh = options.model;
    footage.object.meshUnit = options.unit;
  } else {
    footage.object.cao = options.model;
  }
  footage.object.diameter = measuredDiameter(footage.object);
  footage.model = loadModel(footage.object);
  footage.cam = vpMultiCueSettingsReader::read(options.config, vpMultiCueSettings()).camera;
  const std::vector<int> numbers = readImages(options, footage);
  if (options.poses.empty()) {
    followTruth(options, footage);
    return;
  }
  for (const int number : numbers) {
    const std::string name = numberedPath(options.poses, number);
    footage.truth.push_back(checkedTransform(parseNumbers(readText(name), inQuotes(name)), 1., inQuotes(name)));
    footage.isSeen.push_back(true);
  }
}

void takeColours(BenchImage &I)
{
  I.isGray = true;
  vpImageConvert::convert(I.gray, I.color);
}
} // namespace

Footage openFootage(const DisturbOptions &options)
{
  Footage footage;
  if (options.images.empty()) {
    openScene(options, footage);
    footage.model = loadModel(footage.object);
  } else {
    openRecordedImages(options, footage);
  }
  if (options.gray) {
    for (BenchImage &I : footage.images) {
      takeColours(I);
    }
  }
  return footage;
}

} // namespace bench
