// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/recordingReader.h"

#include "dataset/checkedGeometry.h"
#include "dataset/datasetFiles.h"

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

SequenceFrame readFrame(const Recording &recording, int number, const vpCameraParameters &cam)
{
  SequenceFrame frame;
  frame.id = number;
  frame.image = numberedPath(recording.images, number);
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

// A recording ends with its last image; a gap in its numbers is no end, and other programs go on after it.
void requireNoLater(const Recording &recording, int missing)
{
  const int farthest = 1000; // Numbers that are looked at.
  for (int number = missing; number < missing + farthest; ++number) {
    const std::string image = numberedPath(recording.images, number);
    if (exists(image)) {
      fail("The image " + inQuotes(numberedPath(recording.images, missing)) + " is missing, but " + inQuotes(image) +
           " is there: number the images without gaps, or say which is the last one and the step between them");
    }
  }
}

std::vector<SequenceFrame> readFrames(const Recording &recording, const vpCameraParameters &cam)
{
  std::vector<SequenceFrame> frames;
  for (int number = recording.first; recording.last < 0 || number <= recording.last; number += recording.step) {
    const std::string image = numberedPath(recording.images, number);
    if (!exists(image) && recording.last < 0 && number > recording.first) {
      requireNoLater(recording, number);
      break;
    }
    requireFile(image, "the recording needs it");
    frames.push_back(readFrame(recording, number, cam));
  }
  if (!frames.empty() && !frames.front().hasTruth) {
    requireFile(numberedPath(recording.poses, recording.first), "the first image needs a pose");
  }
  return frames;
}

void check(const Recording &recording)
{
  if (recording.first < 0 || recording.step < 1) {
    fail("The recording '" + recording.name + "' starts at number " + std::to_string(recording.first) +
         " with a step of " + std::to_string(recording.step) + ": neither may be negative, and the step not 0");
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
