// SPDX-License-Identifier: GPL-2.0-or-later
#include "evaluate/overlays.h"

#include "evaluate/base64.h"
#include "evaluate/imageStore.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace bench {

namespace {
const int panelWidth = 320;
const cv::Scalar truthColor(80, 220, 80);
const cv::Scalar estimateColor(60, 60, 255);

using Draw = vpMbMultiCueTracker; // It knows the visible lines of any model.

// One frame, and what all trackers with the same protocol and step made of it.
struct Worst
{
  double badness = 0.; // Error of the worst tracker, in diameters.
  std::vector<const RunResult *> group;
  std::size_t record = 0;
};

double badness(const FrameRecord &record, double diameter)
{
  return record.counted ? std::min(record.error.add / diameter, 10.) : 0.;
}

std::vector<Worst> findWorst(const Evaluation &evaluation)
{
  std::map<std::tuple<std::string, int, int>, std::vector<const RunResult *>> groups;
  for (const RunResult &run : evaluation.runs) {
    const RunKey &key = run.summary.key;
    groups[{key.scene, static_cast<int>(key.protocol), key.step}].push_back(&run);
  }
  std::vector<Worst> worst;
  for (const auto &entry : groups) {
    std::map<std::size_t, Worst> frames; // Two trackers may share their worst frame.
    for (const RunResult *run : entry.second) {
      const double diameter = evaluation.sequenceOf(*run).object.diameter;
      const auto most = std::max_element(run->records.begin(), run->records.end(),
                                         [diameter](const FrameRecord &a, const FrameRecord &b) {
                                           return badness(a, diameter) < badness(b, diameter);
                                         });
      if (most != run->records.end()) {
        Worst &frame = frames[static_cast<std::size_t>(most - run->records.begin())];
        frame.badness = std::max(frame.badness, badness(*most, diameter));
        frame.group = entry.second;
        frame.record = static_cast<std::size_t>(most - run->records.begin());
      }
    }
    for (const auto &frame : frames) {
      worst.push_back(frame.second);
    }
  }
  std::stable_sort(worst.begin(), worst.end(), [](const Worst &a, const Worst &b) { return a.badness > b.badness; });
  return worst;
}

void drawModel(cv::Mat &image, Draw &draw, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
               const cv::Scalar &color)
{
  try {
    const auto lines =
        draw.getModelForDisplay(static_cast<unsigned int>(image.cols), static_cast<unsigned int>(image.rows), cMo, cam);
    for (const std::vector<double> &line : lines) {
      cv::line(image, cv::Point2d(line[2], line[1]), cv::Point2d(line[4], line[3]), color, 1, cv::LINE_AA);
    }
  } catch (const vpException &) {
    // A lost tracker's pose may be one that cannot be drawn.
  }
}

std::string caption(const FrameRecord &record)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << 1e3 * record.error.translation << " mm, " << record.error.rotation
       << " deg, " << toString(record.answer.state) << (record.success ? "" : ", failed");
  return text.str();
}

OverlayRow::Panel makePanel(const cv::Mat &image, const SequenceFrame &frame, Draw &draw, const RunResult &run,
                            const FrameRecord &record)
{
  cv::Mat picture = image.clone();
  drawModel(picture, draw, frame.cMo, frame.cam, truthColor);
  drawModel(picture, draw, record.answer.cMo, frame.cam, estimateColor);
  cv::resize(picture, picture, cv::Size(panelWidth, panelWidth * picture.rows / picture.cols), 0., 0., cv::INTER_AREA);
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", picture, jpeg, {cv::IMWRITE_JPEG_QUALITY, 80});
  return {run.summary.key.tracker, caption(record), toBase64(jpeg)};
}

std::unique_ptr<Draw> makeDraw(const SequenceObject &object)
{
  auto draw = std::make_unique<Draw>();
  draw->setModelUnit(object.meshUnit);
  draw->loadModel(object.mesh.empty() ? object.cao : object.mesh);
  return draw;
}
} // namespace

std::vector<OverlayRow> worstFrames(const Evaluation &evaluation, std::size_t most)
{
  std::vector<OverlayRow> rows;
  std::map<std::string, std::unique_ptr<Draw>> draws;
  for (const Worst &worst : findWorst(evaluation)) {
    if (rows.size() == most) {
      break;
    }
    const Sequence &sequence = evaluation.sequenceOf(*worst.group.front());
    const RunKey &key = worst.group.front()->summary.key;
    const int id = worst.group.front()->records[worst.record].frame;
    const auto frame = std::find_if(sequence.frames.begin(), sequence.frames.end(),
                                    [id](const SequenceFrame &known) { return known.id == id; });
    const cv::Mat image = programs::readColorImage(frame->image);
    if (image.empty()) {
      continue;
    }
    std::unique_ptr<Draw> &draw = draws[sequence.scene];
    draw = draw ? std::move(draw) : makeDraw(sequence.object);
    OverlayRow row;
    row.title = key.scene + ", " + toString(key.protocol) + ", step " + std::to_string(key.step) + ", frame " +
                std::to_string(id);
    for (const RunResult *run : worst.group) {
      row.panels.push_back(makePanel(image, *frame, *draw, *run, run->records[worst.record]));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

} // namespace bench
