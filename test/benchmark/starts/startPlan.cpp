// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/startPlan.h"

#include "evaluate/evaluation.h"

#include <visp3/core/vpException.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace bench {

namespace {
// Of the frame that a trial starts with.
const double wellVisible = 0.8;

Eigen::Vector3d drawUnitVector(vpPoseRandom &random)
{
  Eigen::Vector3d vector;
  do {
    vector = Eigen::Vector3d(random.normal(), random.normal(), random.normal());
  } while (vector.norm() < 1e-6);
  return vector.normalized();
}

vpTranslationVector translation(const Eigen::Vector3d &vector)
{
  return vpTranslationVector(vector.x(), vector.y(), vector.z());
}

std::string modelFile(const SequenceObject &object)
{
  return object.mesh.empty() ? object.cao : object.mesh;
}

void requireOneCamera(const std::vector<Sequence> &sequences)
{
  for (const Sequence &sequence : sequences) {
    for (const SequenceFrame &frame : sequence.frames) {
      if (!sameCamera(frame.cam, sequences.front().frames.front().cam)) {
        throw vpException(vpException::badValue, "%s, frame %d: another camera; take such scenes in calls of their own",
                          sequence.scene.c_str(), frame.id);
      }
    }
  }
}

// A place in the scenes' images.
struct Place
{
  std::size_t scene = 0;
  std::size_t frame = 0;
};

// Frames that a trial may start with: those that follow show something of the object too.
std::vector<Place> ownPlaces(const StartScenes &scenes, const StartObject &object, std::size_t length)
{
  std::vector<Place> places;
  for (const std::size_t scene : object.scenes) {
    const std::vector<SequenceFrame> &frames = scenes.sequences[scene].frames;
    for (std::size_t i = 0; i + length <= frames.size(); ++i) {
      const auto begin = frames.begin() + static_cast<std::ptrdiff_t>(i);
      const bool isSeen =
          std::all_of(begin, begin + static_cast<std::ptrdiff_t>(length),
                      [](const SequenceFrame &frame) { return frame.hasTruth && frame.visibility >= leastVisibility; });
      if (isSeen && begin->visibility >= wellVisible) {
        places.push_back({scene, i});
      }
    }
  }
  if (places.empty()) {
    throw vpException(vpException::badValue, "%s: no %zu frames on end show the object", object.name.c_str(), length);
  }
  return places;
}

std::vector<Place> otherPlaces(const StartScenes &scenes, std::size_t object, std::size_t length)
{
  std::vector<Place> places;
  for (std::size_t other = 0; other < scenes.objects.size(); ++other) {
    if (other == object) {
      continue;
    }
    for (const std::size_t scene : scenes.objects[other].scenes) {
      for (std::size_t i = 0; i + length <= scenes.sequences[scene].frames.size(); ++i) {
        places.push_back({scene, i});
      }
    }
  }
  if (places.empty()) {
    throw vpException(vpException::badValue, "No other object's scene has %zu frames", length);
  }
  return places;
}

const Place &pick(const std::vector<Place> &places, vpPoseRandom &random)
{
  return places[static_cast<std::size_t>(random.index(places.size()))];
}
} // namespace

StartDirection drawDirection(vpPoseRandom &random)
{
  StartDirection direction;
  direction.axis = drawUnitVector(random);
  direction.shift = drawUnitVector(random);
  return direction;
}

vpHomogeneousMatrix deviate(const vpHomogeneousMatrix &cMo, const Eigen::Vector3d &centre,
                            const StartDirection &direction, double angle, double distance)
{
  const Eigen::Vector3d turn = angle * direction.axis;
  const vpHomogeneousMatrix oMb(translation(centre), vpRotationMatrix());
  const vpHomogeneousMatrix cMb = cMo * oMb;
  const Eigen::Vector3d place = Eigen::Vector3d(cMb[0][3], cMb[1][3], cMb[2][3]) + distance * direction.shift;
  const vpRotationMatrix cRb = vpRotationMatrix(vpThetaUVector(turn.x(), turn.y(), turn.z())) * cMb.getRotationMatrix();
  return vpHomogeneousMatrix(translation(place), cRb) * oMb.inverse();
}

StartScenes openScenes(const StartOptions &options)
{
  const bool all = options.scenes.size() == 1 && options.scenes.front() == "all";
  StartScenes scenes;
  std::map<std::string, StartObject> objects; // By file: RBOT's all have one number.
  for (const std::string &name : all ? listScenes(options.dataset) : options.scenes) {
    scenes.sequences.push_back(openSequence(options.dataset, name));
    StartObject &object = objects[modelFile(scenes.sequences.back().object)];
    object.files = scenes.sequences.back().object;
    object.scenes.push_back(scenes.sequences.size() - 1);
  }
  requireOneCamera(scenes.sequences);
  for (auto &entry : objects) {
    entry.second.name = std::filesystem::path(entry.first).stem().string();
    entry.second.model = loadModel(entry.second.files);
    scenes.objects.push_back(std::move(entry.second));
  }
  if (options.wrong != WrongStart::NOTHING && scenes.objects.size() < 2) {
    throw vpException(vpException::badValue, "--wrong needs scenes of several objects: name them with --scene");
  }
  return scenes;
}

std::vector<StartTrial> planTrials(const StartOptions &options, const StartScenes &scenes, std::size_t object)
{
  const std::size_t length = static_cast<std::size_t>(options.frames);
  const std::vector<Place> own = ownPlaces(scenes, scenes.objects[object], length);
  const std::vector<Place> others =
      options.wrong == WrongStart::SCENE ? otherPlaces(scenes, object, length) : std::vector<Place>();
  std::vector<StartTrial> trials(static_cast<std::size_t>(options.trials));
  for (std::size_t i = 0; i < trials.size(); ++i) {
    vpPoseRandom random(static_cast<std::uint64_t>(options.seed), {object, i});
    StartTrial &trial = trials[i];
    const Place place = pick(own, random);
    trial.direction = drawDirection(random);
    const Place image = options.wrong == WrongStart::SCENE ? pick(others, random) : place;
    trial.object = object;
    trial.model = object;
    if (options.wrong == WrongStart::MODEL) { // Each of the others as often.
      trial.model = (object + 1 + i % (scenes.objects.size() - 1)) % scenes.objects.size();
    }
    trial.scene = place.scene;
    trial.frame = place.frame;
    trial.imageScene = image.scene;
    trial.imageFrame = image.frame;
  }
  return trials;
}

SequenceObject scaledTo(const SequenceObject &other, const SequenceObject &object)
{
  SequenceObject scaled = other;
  if (!other.mesh.empty()) {
    const double factor = object.diameter / other.diameter;
    scaled.meshUnit *= factor;
    scaled.diameter *= factor;
  }
  return scaled;
}

} // namespace bench
