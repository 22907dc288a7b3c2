// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/recordingReader.h"

#include "dataset/checkedGeometry.h"
#include "dataset/datasetFiles.h"
#include "frames/filePattern.h"

#include <visp3/model/vpModelReader.h>
#include <visp3/multicue/vpMultiCueSettings.h>
#include <visp3/se3/vpExactNumber.h>

namespace fs = std::filesystem;

namespace bench {
namespace {
bool exists(const std::string &file)
{
  std::error_code ignored;
  return fs::is_regular_file(file, ignored);
}

vpCameraParameters readCamera(const std::string &file)
{
  requireFile(file, "it has the camera");
  // What comes back unchanged was not in the file: no camera has a focal length of one pixel.
  vpMultiCueSettings none;
  none.camera = vpCameraParameters(1., 1., 0., 0.);
  const vpCameraParameters cam = vpMultiCueSettingsReader::read(file, none).camera;
  if (vpIsSame(cam.get_px(), none.camera.get_px()) && vpIsSame(cam.get_py(), none.camera.get_py())) {
    fail("The file " + inQuotes(file) + " has no camera");
  }
  return cam;
}

SequenceObject readObject(const Recording &recording)
{
  requireFile(recording.model, "it is the object's model");
  SequenceObject object;
  if (vpModelReader::isMesh(recording.model)) {
    object.mesh = recording.model;
    object.meshUnit = recording.unit;
  } else {
    object.cao = recording.model;
  }
  object.diameter = measuredDiameter(object);
  return object;
}

SequenceFrame readFrame(const Recording &recording, int number, const std::string &image, const vpCameraParameters &cam)
{
  SequenceFrame frame;
  frame.id = number;
  frame.image = image;
  frame.cam = cam;
  const std::string poseFile = numberedPath(recording.poses, number);
  frame.hasTruth = exists(poseFile);
  if (frame.hasTruth) {
    const std::string place = inQuotes(poseFile);
    frame.cMo = checkedTransform(parseNumbers(readText(poseFile), place), 1., place);
    requireInFront(frame.cMo, place);
  }
  return frame;
}

std::vector<SequenceFrame> readFrames(const Recording &recording, const vpCameraParameters &cam)
{
  std::vector<SequenceFrame> frames;
  const programs::FilePattern images(recording.images);
  for (const auto &[number, image] : images.frames(recording.first, recording.last, recording.step)) {
    frames.push_back(readFrame(recording, number, image, cam));
  }
  if (!frames.empty() && !frames.front().hasTruth) {
    requireFile(numberedPath(recording.poses, frames.front().id), "the first image needs a pose");
  }
  return frames;
}

void check(const Recording &recording)
{
  if (recording.step < 1) {
    fail("The recording '" + recording.name + "' has a step of " + std::to_string(recording.step) +
         " from image to image: it has to be 1 or more");
  }
}
} // namespace

Sequence recordingReader::open(const Recording &recording)
{
  check(recording);
  Sequence sequence;
  sequence.scene = recording.name;
  sequence.frames = readFrames(recording, readCamera(recording.camera));
  startAtFirstTruth(sequence.frames, "The recording '" + recording.images + "'");
  sequence.object = readObject(recording);
  return sequence;
}

} // namespace bench
