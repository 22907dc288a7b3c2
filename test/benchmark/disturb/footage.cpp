// SPDX-License-Identifier: GPL-2.0-or-later
#include "disturb/footage.h"

#include "dataset/checkedGeometry.h"
#include "dataset/datasetFiles.h"
#include "evaluate/evaluation.h"
#include "evaluate/imageStore.h"
#include "evaluate/poseError.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpPoseVector.h>
#include <visp3/io/vpVideoReader.h>
#include <visp3/model/vpModelReader.h>
#include <visp3/multicue/vpMultiCueSettings.h>

#include <fstream>

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

void readImages(const DisturbOptions &options, Footage &footage)
{
  vpVideoReader reader;
  reader.setFileName(options.images);
  if (options.images.find('%') != std::string::npos) {
    reader.setFirstFrameIndex(options.first);
    if (options.last >= 0) {
      reader.setLastFrameIndex(options.last);
    }
  }
  vpImage<vpRGBa> I;
  reader.open(I);
  while (!reader.end()) {
    reader.acquire(I);
    footage.images.emplace_back();
    footage.images.back().color = I;
    vpImageConvert::convert(I, footage.images.back().gray);
  }
}

vpHomogeneousMatrix readStart(const std::string &name)
{
  std::ifstream file(name);
  vpPoseVector pose;
  for (unsigned int i = 0; i < 6; ++i) {
    if (!(file >> pose[i])) {
      throw vpException(vpException::ioError, "The start '%s' cannot be read: it must have 6 numbers", name.c_str());
    }
  }
  return vpHomogeneousMatrix(pose);
}

// Where the followers have the object.
void followTruth(const DisturbOptions &options, Footage &footage)
{
  const vpHomogeneousMatrix start = readStart(options.start);
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
  readImages(options, footage);
  if (options.poses.empty()) {
    followTruth(options, footage);
    return;
  }
  for (std::size_t i = 0; i < footage.images.size(); ++i) {
    const std::string name = numberedPath(options.poses, options.first + static_cast<int>(i));
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
