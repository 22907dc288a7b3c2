// SPDX-License-Identifier: GPL-2.0-or-later
#include "anywhere/anywhereTrials.h"

#include "drawing/modelDrawing.h"
#include "evaluate/imageStore.h"
#include "evaluate/poseError.h"
#include "evaluate/protocol.h"
#include "frames/pictureFile.h"
#include "starts/startPlan.h"

#include <processorTime.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpIoTools.h>
#include <visp3/core/vpTime.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>

namespace bench {

namespace {
// Share of the silhouette that an image has to show.
const double leastSeen = 0.5;
const cv::Scalar truthColor(80, 220, 80);
const cv::Scalar foundColor(60, 60, 255);

struct Place
{
  std::size_t scene = 0;
  std::size_t frame = 0;
};

// All trials of one object, whose tracker is made once.
class ObjectTrials
{
public:
  ObjectTrials(const AnywhereOptions &options, const StartScenes &scenes, std::size_t object, std::ostream &log)
      : m_options(options), m_scenes(scenes), m_object(scenes.objects[object]), m_log(log),
        m_measure(m_object.files, *m_object.model), m_limits(m_object.files.diameter),
        m_tracker(
            makeTracker(options.tracker, m_object.files, scenes.sequences.front().frames.front().cam, options.config))
  {
    m_count.object = m_object.name;
    m_draw.setModelUnit(m_object.files.meshUnit);
    m_draw.loadModel(m_object.files.mesh.empty() ? m_object.files.cao : m_object.files.mesh);
  }

  AnywhereCount run(const std::vector<Place> &places)
  {
    std::size_t scene = m_scenes.sequences.size();
    std::unique_ptr<ImageStore> images;
    for (const Place &place : places) {
      if (place.scene != scene) {
        scene = place.scene;
        images = std::make_unique<ImageStore>(m_scenes.sequences[scene]);
      }
      start(place, *images);
    }
    return m_count;
  }

private:
  void start(const Place &place, ImageStore &images)
  {
    const SequenceFrame &frame = m_scenes.sequences[place.scene].frames[place.frame];
    BenchImage I;
    images.get(place.frame, I);
    I.isGray = m_options.gray;
    const double begin = vpTime::measureTimeSecond();
    const double cpuBegin = processorTime();
    const bool isAccepted = m_tracker->startAnywhere(I, m_options.nearest, m_options.farthest);
    const double cpu = processorTime() - cpuBegin;
    if (m_count.images == 0) {
      m_count.first = cpu;
    } else {
      m_count.cpuSeconds.push_back(cpu);
      m_count.seconds.push_back(vpTime::measureTimeSecond() - begin);
    }
    const TrackerAnswer answer = m_tracker->answer();
    const PoseError error = m_measure(answer.cMo, frame.cMo, frame.cam);
    const bool isRight = isSuccess(error);
    ++m_count.images;
    m_count.acceptedRight += isAccepted && isRight ? 1 : 0;
    m_count.acceptedWrong += isAccepted && !isRight ? 1 : 0;
    m_count.refusedRight += !isAccepted && isRight ? 1 : 0;
    report(place, isAccepted, isRight, error, cpu);
    if (!m_options.overlays.empty() && (isAccepted ? !isRight : !m_options.absent)) {
      draw(place, I, answer.cMo, isAccepted);
    }
    if (isAccepted) {
      follow(place, images);
    }
  }

  // The wrong object's pose is never right.
  bool isSuccess(const PoseError &error) const
  {
    return !m_options.absent && error.translation < m_limits.successTranslation &&
           error.rotation < m_limits.successRotation;
  }

  void follow(const Place &place, ImageStore &images)
  {
    const std::vector<SequenceFrame> &frames = m_scenes.sequences[place.scene].frames;
    const std::size_t end = std::min(place.frame + static_cast<std::size_t>(m_options.follow), frames.size());
    std::size_t last = place.frame;
    for (std::size_t i = place.frame; i < end; ++i) {
      BenchImage I;
      images.get(i, I);
      I.isGray = m_options.gray;
      m_tracker->track(I);
      last = i;
    }
    const TrackerAnswer answer = m_tracker->answer();
    if (answer.state == vpTrackingState::TRACKING) {
      const bool isRight = isSuccess(m_measure(answer.cMo, frames[last].cMo, frames[last].cam));
      ++(isRight ? m_count.followedRight : m_count.followedWrong);
    }
  }

  void report(const Place &place, bool isAccepted, bool isRight, const PoseError &error, double seconds)
  {
    const Sequence &sequence = m_scenes.sequences[place.scene];
    m_log << m_object.name << " in " << sequence.scene << " " << sequence.frames[place.frame].id << ": "
          << (isAccepted ? "accepted" : "refused") << (isRight ? ", right" : ", wrong");
    if (!m_options.absent) {
      m_log << std::fixed << std::setprecision(1) << ", " << 1e3 * error.translation << " mm, " << error.rotation
            << " degrees";
    }
    m_log << std::fixed << std::setprecision(2) << ", " << seconds << " s. " << m_tracker->text() << std::endl;
  }

  void draw(const Place &place, const BenchImage &I, const vpHomogeneousMatrix &cMo, bool isAccepted)
  {
    const Sequence &sequence = m_scenes.sequences[place.scene];
    const SequenceFrame &frame = sequence.frames[place.frame];
    cv::Mat picture;
    vpImageConvert::convert(I.color, picture);
    if (!m_options.absent) {
      drawAt(picture, frame.cMo, frame.cam, truthColor);
    }
    drawAt(picture, cMo, frame.cam, foundColor);
    programs::drawText(picture, {isAccepted ? "accepted" : "refused", m_tracker->text()}, {8, 20}, foundColor);
    std::ostringstream name;
    name << m_options.overlays << "/" << m_object.name << "_in_" << sequence.scene << "_" << frame.id << ".png";
    programs::writePicture(name.str(), picture);
  }

  void drawAt(cv::Mat &picture, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, const cv::Scalar &color)
  {
    try {
      programs::drawModel(picture, m_draw, cMo, cam, color, 1);
    } catch (const vpException &) {
      // A refused pose may be one that cannot be drawn.
    }
  }

  const AnywhereOptions &m_options;
  const StartScenes &m_scenes;
  const StartObject &m_object;
  std::ostream &m_log;
  PoseErrorMeasure m_measure;
  Limits m_limits;
  std::unique_ptr<BenchTracker> m_tracker;
  vpMbMultiCueTracker m_draw; // It knows the visible lines of any model.
  AnywhereCount m_count;
};

std::vector<Place> placesOf(const AnywhereOptions &options, const StartScenes &scenes, std::size_t object)
{
  std::vector<Place> all;
  for (std::size_t other = 0; other < scenes.objects.size(); ++other) {
    if ((other == object) == options.absent) {
      continue;
    }
    for (const std::size_t scene : scenes.objects[other].scenes) {
      const std::vector<SequenceFrame> &frames = scenes.sequences[scene].frames;
      for (std::size_t i = 0; i < frames.size(); i += static_cast<std::size_t>(options.every)) {
        if (frames[i].hasTruth && frames[i].visibility >= leastSeen) {
          all.push_back({scene, i});
        }
      }
    }
  }
  const std::size_t most = std::min(static_cast<std::size_t>(options.most), all.size());
  std::vector<Place> places;
  for (std::size_t i = 0; i < most; ++i) {
    places.push_back(all[i * all.size() / most]);
  }
  return places;
}

void addRow(const AnywhereCount &count, bool follows, std::ostream &text)
{
  const auto percent = [&count](int number) { return 100. * number / std::max(count.images, 1); };
  text << std::fixed << std::setprecision(1) << "| " << count.object << " | " << count.images << " | "
       << percent(count.acceptedRight) << " | " << percent(count.acceptedWrong) << " | "
       << percent(count.images - count.acceptedRight - count.acceptedWrong) << " | " << percent(count.refusedRight);
  if (follows) {
    text << " | " << percent(count.followedRight) << " | " << percent(count.followedWrong);
  }
  text << std::setprecision(2);
  for (const std::vector<double> &seconds : {count.cpuSeconds, count.seconds}) {
    text << " | " << AnywhereCount::quantile(seconds, 0.5) << " | " << AnywhereCount::quantile(seconds, 0.99);
  }
  text << " | " << count.first << " |\n";
}
} // namespace

void AnywhereCount::add(const AnywhereCount &other)
{
  images += other.images;
  acceptedRight += other.acceptedRight;
  acceptedWrong += other.acceptedWrong;
  refusedRight += other.refusedRight;
  followedRight += other.followedRight;
  followedWrong += other.followedWrong;
  seconds.insert(seconds.end(), other.seconds.begin(), other.seconds.end());
  cpuSeconds.insert(cpuSeconds.end(), other.cpuSeconds.begin(), other.cpuSeconds.end());
  first = std::max(first, other.first);
}

double AnywhereCount::quantile(std::vector<double> values, double share)
{
  if (values.empty()) {
    return std::nan("");
  }
  std::sort(values.begin(), values.end());
  const double place = std::ceil(share * static_cast<double>(values.size())) - 1.;
  return values[static_cast<std::size_t>(std::max(place, 0.))];
}

std::vector<AnywhereCount> runAnywhere(const AnywhereOptions &options, std::ostream &log)
{
  StartOptions opened;
  opened.dataset = options.dataset;
  opened.scenes = options.scenes;
  opened.wrong = options.absent ? WrongStart::SCENE : WrongStart::NOTHING;
  const StartScenes scenes = openScenes(opened);
  if (!options.overlays.empty()) {
    vpIoTools::makeDirectory(options.overlays);
  }
  std::vector<AnywhereCount> counts;
  for (std::size_t object = 0; object < scenes.objects.size(); ++object) {
    counts.push_back(ObjectTrials(options, scenes, object, log).run(placesOf(options, scenes, object)));
  }
  return counts;
}

std::string anywhereMarkdown(const std::vector<AnywhereCount> &counts, bool follows)
{
  std::ostringstream text;
  text << "| object | images | accepted, right % | accepted, wrong % | refused % | refused, but right % |"
       << (follows ? " followed, right % | followed, wrong % |" : "")
       << " CPU s | 99 % of them | s | 99 % of them | first call, CPU s |\n|---|---|---|---|---|---|"
       << (follows ? "---|---|" : "") << "---|---|---|---|---|\n";
  AnywhereCount all;
  all.object = "all";
  for (const AnywhereCount &count : counts) {
    addRow(count, follows, text);
    all.add(count);
  }
  addRow(all, follows, text);
  return text.str();
}

} // namespace bench
