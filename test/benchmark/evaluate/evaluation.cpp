// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/evaluation.h"

#include "program/threads.h"
#include "program/workers.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpExactNumber.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace bench {

namespace {
std::string readText(const std::string &file)
{
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw vpException(vpException::ioError, "--config: '%s' cannot be read", file.c_str());
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void checkCamera(const Sequence &sequence)
{
  for (const SequenceFrame &frame : sequence.frames) {
    if (!sameCamera(frame.cam, sequence.frames.front().cam)) {
      throw vpException(vpException::badValue, "%s: the camera of frame %d is not that of the first frame",
                        sequence.scene.c_str(), frame.id);
    }
  }
}

std::vector<std::string> chosenScenes(const EvaluateOptions &options)
{
  const bool all = options.scenes.size() == 1 && options.scenes.front() == "all";
  return all ? listScenes(options.dataset) : options.scenes;
}

Sequence open(const EvaluateOptions &options, const std::string &scene)
{
  Sequence sequence =
      options.hasRecording() ? openRecording(options.recording) : openSequence(options.dataset, scene, options.object);
  checkCamera(sequence);
  if (options.frames > 0 && sequence.frames.size() > static_cast<std::size_t>(options.frames)) {
    sequence.frames.resize(static_cast<std::size_t>(options.frames));
  }
  return sequence;
}

void openAll(const EvaluateOptions &options, Evaluation &evaluation)
{
  const std::vector<std::string> scenes =
      options.hasRecording() ? std::vector<std::string>{options.recording.name} : chosenScenes(options);
  for (const std::string &scene : scenes) {
    try {
      evaluation.sequences.push_back(open(options, scene));
      for (const std::string &note : evaluation.sequences.back().notes) {
        evaluation.skipped.push_back({scene, note});
      }
    } catch (const vpException &e) {
      evaluation.failures.push_back({scene, e.getStringMessage()});
    }
  }
}

// All runs of one tracker on one scene: they share the decoded images and the loaded model.
class TrackerOnScene
{
public:
  TrackerOnScene(const EvaluateOptions &options, const Sequence &sequence, const std::string &tracker,
                 const std::string &configText)
      : m_options(options), m_sequence(sequence), m_tracker(tracker), m_configText(configText)
  {
  }

  std::string name() const { return m_sequence.scene + ", " + m_tracker; }

  std::vector<RunKey> keys() const
  {
    std::vector<RunKey> keys;
    for (const Protocol protocol : m_options.protocols) {
      for (const int step : m_options.steps) {
        keys.push_back({m_sequence.scene, m_tracker, protocol, step});
      }
    }
    return keys;
  }

  std::string fingerprint() const
  {
    std::ostringstream text;
    text << (m_options.hasRecording() ? m_options.recording.images : vpIoTools::getAbsolutePathname(m_options.dataset))
         << " object " << m_sequence.object.id << ", " << m_sequence.frames.size() << " frames, " << m_options.threads
         << " threads, ";
    if (m_options.start.pixels > 0.) {
      text << "starts " << m_options.start.pixels << " px off, seed " << m_options.start.seed << ", ";
    }
    for (const std::string &cue : m_options.cues) {
      text << "cue " << cue << ", ";
    }
    text << "config " << m_configText;
    return text.str();
  }

  std::string folder() const { return m_options.out + "/runs"; }

  std::vector<RunKey> missing(const vpTrackedModel &model) const
  {
    std::vector<RunKey> missing;
    for (const RunKey &key : keys()) {
      RunResult run;
      if (!m_options.resume || !read(key, model, run)) {
        missing.push_back(key);
      }
    }
    return missing;
  }

  bool read(const RunKey &key, const vpTrackedModel &model, RunResult &run) const
  {
    const PoseErrorMeasure measure(m_sequence.object, model);
    return readRun(folder(), key, fingerprint(), m_sequence.object.diameter, measure.isSymmetric(), run);
  }

  void execute(const std::vector<RunKey> &runs, const vpTrackedModel &model, const std::function<void()> &oneMore) const
  {
    setThreads(m_options.threads);
    ImageStore images(m_sequence);
    const PoseErrorMeasure measure(m_sequence.object, model);
    const StartPose start = [&](const SequenceFrame &frame) {
      return m_options.start.at(m_sequence.scene, frame, model, measure);
    };
    for (const RunKey &key : runs) {
      const std::unique_ptr<BenchTracker> tracker = makeTracker(
          m_tracker, m_sequence.object, m_sequence.frames.front().cam, m_options.config, cuesNamed(m_options.cues));
      RunResult run;
      run.records = runProtocol(m_sequence, images, *tracker, measure, key.protocol, key.step, oneMore, start);
      run.summary = summarise(key, run.records, m_sequence.object.diameter, measure.isSymmetric(), tracker->stages());
      writeRun(folder(), run, fingerprint());
    }
  }

  Work work(const std::shared_ptr<const vpTrackedModel> &model) const
  {
    const std::vector<RunKey> runs = missing(*model);
    Work work;
    work.name = name();
    for (const RunKey &key : runs) {
      work.size += trackedFrames(m_sequence, key.step);
    }
    work.execute = [this, runs, model](const std::function<void()> &oneMore) { execute(runs, *model, oneMore); };
    return work;
  }

private:
  const EvaluateOptions &m_options;
  const Sequence &m_sequence;
  std::string m_tracker;
  const std::string &m_configText;
};

void collect(const TrackerOnScene &part, const vpTrackedModel &model, const std::string &failure,
             Evaluation &evaluation)
{
  for (const RunKey &key : part.keys()) {
    RunResult run;
    if (part.read(key, model, run)) {
      evaluation.runs.push_back(std::move(run));
    }
  }
  if (!failure.empty()) {
    evaluation.failures.push_back({part.name(), failure});
  }
}

// Results of an earlier call would be taken for those of a run that fails now.
void removeOldRuns(const TrackerOnScene &part)
{
  for (const RunKey &key : part.keys()) {
    for (const char *extension : {".json", ".csv"}) {
      const std::string file = part.folder() + "/" + key.fileName() + extension;
      if (vpIoTools::checkFilename(file)) {
        vpIoTools::remove(file);
      }
    }
  }
}
} // namespace

bool sameCamera(const vpCameraParameters &a, const vpCameraParameters &b)
{
  return vpIsSame(a.get_px(), b.get_px()) && vpIsSame(a.get_py(), b.get_py()) && vpIsSame(a.get_u0(), b.get_u0()) &&
         vpIsSame(a.get_v0(), b.get_v0());
}

std::shared_ptr<const vpTrackedModel> loadModel(const SequenceObject &object)
{
  // The tracker's own way to load, so that every model it can track can be measured.
  vpMbMultiCueTracker tracker;
  tracker.setModelUnit(object.meshUnit);
  tracker.loadModel(object.mesh.empty() ? object.cao : object.mesh);
  return tracker.getModel();
}

const Sequence &Evaluation::sequenceOf(const RunResult &run) const
{
  return *std::find_if(sequences.begin(), sequences.end(),
                       [&run](const Sequence &sequence) { return sequence.scene == run.summary.key.scene; });
}

Evaluation evaluate(const EvaluateOptions &options)
{
  const std::string configText = options.config.empty() ? "" : readText(options.config);
  setThreads(1); // Workers are forks, which inherit no pool of threads in order.
  Evaluation evaluation;
  openAll(options, evaluation);
  vpIoTools::makeDirectory(options.out + "/runs");

  std::vector<TrackerOnScene> parts;
  std::vector<std::shared_ptr<const vpTrackedModel>> models;
  std::vector<Work> works;
  parts.reserve(evaluation.sequences.size() * options.trackers.size()); // Work refers to its part.
  std::map<std::string, std::shared_ptr<const vpTrackedModel>> loaded;  // Scenes share objects.
  for (const Sequence &sequence : evaluation.sequences) {
    std::shared_ptr<const vpTrackedModel> &model = loaded[sequence.object.mesh + sequence.object.cao];
    try {
      model = model ? model : loadModel(sequence.object);
    } catch (const vpException &e) {
      evaluation.failures.push_back({sequence.scene, e.getStringMessage()});
      continue;
    }
    for (const std::string &tracker : options.trackers) {
      if (needsCao(tracker) && sequence.object.cao.empty()) {
        evaluation.skipped.push_back({sequence.scene + ", " + tracker, "the object has no .cao model"});
        continue;
      }
      parts.emplace_back(options, sequence, tracker, configText);
      if (!options.resume) {
        removeOldRuns(parts.back());
      }
      models.push_back(model);
      works.push_back(parts.back().work(model));
    }
  }
  const std::vector<std::string> failures = runWork(works, options.jobs, options.out + "/log.txt");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    collect(parts[i], *models[i], failures[i], evaluation);
  }
  return evaluation;
}

} // namespace bench
