// SPDX-License-Identifier: GPL-2.0-or-later
#include "starts/startTrials.h"

#include "evaluate/evaluation.h"
#include "program/threads.h"
#include "program/workers.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>
#include <visp3/core/vpMath.h>
#include <visp3/model/vpWholeFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

namespace bench {

namespace {
using Json = nlohmann::json;

// What a worker tells of a trial: its place in the plan says the rest. JSON has no infinity and no "not a number".
Json toJson(const StartRecord &record)
{
  const auto finite = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  return {static_cast<int>(record.outcome), static_cast<int>(record.state), finite(record.score), record.right,
          finite(record.translation),       finite(record.rotation)};
}

void read(const Json &json, StartRecord &record)
{
  const auto number = [](const Json &value) { return value.is_null() ? std::nan("") : value.get<double>(); };
  record.outcome = static_cast<StartOutcome>(json.at(0).get<int>());
  record.state = static_cast<vpTrackingState>(json.at(1).get<int>());
  record.score = number(json.at(2));
  record.right = json.at(3);
  record.translation = number(json.at(4));
  record.rotation = number(json.at(5));
}

// All trials of one tracker on one object.
class ObjectTrials
{
public:
  ObjectTrials(const StartOptions &options, const StartScenes &scenes, const std::string &tracker, std::size_t object)
      : m_options(options), m_scenes(scenes), m_tracker(tracker), m_object(object),
        m_trials(planTrials(options, scenes, object)), m_deviations(options.deviations()),
        m_file(options.out + "/" + tracker + "_" + std::to_string(object) + ".part")
  {
  }

  Work work() const
  {
    Work work;
    work.name = m_tracker + ", " + m_scenes.objects[m_object].name;
    work.size = m_trials.size();
    work.execute = [this](const std::function<void()> &oneMore) { execute(oneMore); };
    return work;
  }

  // What the worker wrote.
  void collect(std::vector<StartRecord> &records) const
  {
    std::ifstream stream(m_file);
    const Json results = Json::parse(stream, nullptr, false);
    if (results.is_discarded()) {
      return;
    }
    for (std::size_t d = 0; d < m_deviations.size(); ++d) {
      for (std::size_t i = 0; i < m_trials.size(); ++i) {
        StartRecord record = planned(m_trials[i], m_deviations[d]);
        read(results.at(i).at(d), record);
        records.push_back(record);
      }
    }
    stream.close();
    vpIoTools::remove(m_file);
  }

private:
  StartRecord planned(const StartTrial &trial, const StartDeviation &deviation) const
  {
    StartRecord record;
    record.tracker = m_tracker;
    record.object = m_scenes.objects[trial.object].name;
    record.model = m_scenes.objects[trial.model].name;
    const Sequence &scene = m_scenes.sequences[trial.scene];
    const Sequence &imageScene = m_scenes.sequences[trial.imageScene];
    record.scene = scene.scene;
    record.frame = scene.frames[trial.frame].id;
    record.imageScene = imageScene.scene;
    record.imageFrame = imageScene.frames[trial.imageFrame].id;
    record.deviation = deviation;
    return record;
  }

  // One scene after the other, so that the images of one are in memory, and each model's tracker is made once.
  void execute(const std::function<void()> &oneMore) const
  {
    setThreads(m_options.threads);
    std::vector<std::size_t> order(m_trials.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return m_trials[a].imageScene < m_trials[b].imageScene; });
    std::map<std::size_t, std::unique_ptr<BenchTracker>> trackers; // By model.
    std::unique_ptr<ImageStore> images;
    std::size_t scene = m_scenes.sequences.size();
    std::vector<Json> results(m_trials.size());
    for (const std::size_t i : order) {
      if (m_trials[i].imageScene != scene) {
        scene = m_trials[i].imageScene;
        images = std::make_unique<ImageStore>(m_scenes.sequences[scene]);
      }
      std::unique_ptr<BenchTracker> &tracker = trackers[m_trials[i].model];
      if (!tracker) {
        tracker = makeTracker(m_tracker, filesOf(m_trials[i].model), m_scenes.sequences.front().frames.front().cam,
                              m_options.config);
      }
      results[i] = Json::array();
      for (const StartDeviation &deviation : m_deviations) {
        results[i].push_back(toJson(run(m_trials[i], deviation, *tracker, *images)));
      }
      oneMore();
    }
    vpWholeFile::write(m_file, Json(results).dump());
  }

  SequenceObject filesOf(std::size_t model) const
  {
    const StartObject &own = m_scenes.objects[m_object];
    return model == m_object ? own.files : scaledTo(m_scenes.objects[model].files, own.files);
  }

  // Of the model that the tracker has, in its own frame, as large as it was loaded.
  Eigen::Vector3d centreOf(std::size_t model) const
  {
    const StartObject &object = m_scenes.objects[model];
    return object.centre() * (filesOf(model).diameter / object.files.diameter);
  }

  StartRecord run(const StartTrial &trial, const StartDeviation &deviation, BenchTracker &tracker,
                  ImageStore &images) const
  {
    const StartObject &object = m_scenes.objects[trial.object];
    const std::vector<SequenceFrame> &frames = m_scenes.sequences[trial.scene].frames;
    const double diameter = object.files.diameter;
    vpHomogeneousMatrix start = deviate(frames[trial.frame].cMo, object.centre(), trial.direction,
                                        vpMath::rad(deviation.angle), deviation.offset * diameter);
    if (trial.model != trial.object) { // Its centre is where the object's is.
      const Eigen::Vector3d move = object.centre() - centreOf(trial.model);
      start = start * vpHomogeneousMatrix(move.x(), move.y(), move.z(), 0., 0., 0.);
    }
    const TrackerAnswer answer = tryStart(tracker, images, trial, start, deviation, diameter, m_options.frames);
    return judged(trial, deviation, answer);
  }

  StartRecord judged(const StartTrial &trial, const StartDeviation &deviation, const TrackerAnswer &answer) const
  {
    StartRecord record = planned(trial, deviation);
    record.state = answer.state;
    record.score = answer.score;
    if (m_options.wrong == WrongStart::NOTHING) {
      const StartObject &object = m_scenes.objects[trial.object];
      const SequenceFrame &last =
          m_scenes.sequences[trial.scene].frames[trial.frame + static_cast<std::size_t>(m_options.frames) - 1];
      const PoseErrorMeasure measure(object.files, *object.model);
      const PoseError error = measure(answer.cMo, last.cMo, last.cam);
      const Limits limits(object.files.diameter);
      record.translation = error.translation;
      record.rotation = error.rotation;
      record.right = error.translation < limits.rightTranslation && error.rotation < limits.rightRotation;
    } else {
      record.translation = std::nan("");
      record.rotation = std::nan("");
    }
    record.outcome = answer.state != vpTrackingState::TRACKING ? StartOutcome::REFUSED
                     : record.right                            ? StartOutcome::RIGHT
                                                               : StartOutcome::WRONG;
    return record;
  }

  const StartOptions &m_options;
  const StartScenes &m_scenes;
  std::string m_tracker;
  std::size_t m_object;
  std::vector<StartTrial> m_trials;
  std::vector<StartDeviation> m_deviations;
  std::string m_file;
};
} // namespace

TrackerAnswer tryStart(BenchTracker &tracker, ImageStore &images, const StartTrial &trial,
                       const vpHomogeneousMatrix &start, const StartDeviation &deviation, double diameter, int frames)
{
  BenchImage I;
  images.get(trial.imageFrame, I);
  try {
    tracker.startRoughly(I, start, vpMath::rad(deviation.angle), deviation.offset * diameter);
  } catch (const vpException &) {
    TrackerAnswer refused; // Behind the camera, for instance.
    refused.cMo = start;
    return refused;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i) {
    if (i > 0) {
      images.get(trial.imageFrame + i, I);
    }
    tracker.track(I);
  }
  return tracker.answer();
}

StartResults runStarts(const StartOptions &options)
{
  setThreads(1); // Workers are forks, which inherit no pool of threads in order.
  const StartScenes scenes = openScenes(options);
  vpIoTools::makeDirectory(options.out);
  std::vector<ObjectTrials> parts;
  StartResults results;
  for (const std::string &tracker : options.trackers) {
    for (std::size_t object = 0; object < scenes.objects.size(); ++object) {
      parts.emplace_back(options, scenes, tracker, object);
    }
  }
  std::vector<Work> works;
  std::transform(parts.begin(), parts.end(), std::back_inserter(works),
                 [](const ObjectTrials &part) { return part.work(); });
  const std::vector<std::string> failures = runWork(works, options.jobs, options.out + "/log.txt");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (failures[i].empty()) {
      parts[i].collect(results.records);
    } else {
      results.failures.push_back(works[i].name + ": " + failures[i]);
    }
  }
  return results;
}

} // namespace bench
