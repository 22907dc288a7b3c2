// SPDX-License-Identifier: GPL-2.0-or-later
#include "disturb/disturbTrials.h"

#include "evaluate/startPoses.h"

#include <visp3/core/vpException.h>
#include <visp3/core/vpTime.h>
#include <visp3/se3/vpPoseExponential.h>

#include <algorithm>
#include <cmath>

namespace bench {

namespace {
// Images that are tracked before one is shifted.
const std::size_t framesBefore = 10;
const int directions = 8;
// No motion shifts an image exactly: the best pose in it is off by so many times more.
const double shiftedFactor = 3.;

double medianOf(std::vector<double> values)
{
  if (values.empty()) {
    return std::nan("");
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <typename Action> double timed(const Action &action)
{
  const double begin = vpTime::measureTimeMs();
  action();
  return vpTime::measureTimeMs() - begin;
}

// What comes in at the border repeats it.
template <typename Pixel> void shift(const vpImage<Pixel> &I, int right, int down, vpImage<Pixel> &shifted)
{
  const int width = static_cast<int>(I.getWidth());
  const int height = static_cast<int>(I.getHeight());
  shifted.resize(I.getHeight(), I.getWidth());
  for (int v = 0; v < height; ++v) {
    const int from = std::min(std::max(v - down, 0), height - 1);
    for (int u = 0; u < width; ++u) {
      shifted[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)] =
          I[static_cast<unsigned int>(from)][static_cast<unsigned int>(std::min(std::max(u - right, 0), width - 1))];
    }
  }
}
} // namespace

double DisturbCount::median() const
{
  return medianOf(pixels);
}

double DisturbCount::medianMs() const
{
  return medianOf(ms);
}

double DisturbCount::medianStartMs() const
{
  return medianOf(startMs);
}

DisturbTrials::DisturbTrials(const DisturbOptions &options, const Footage &footage)
    : m_options(options), m_footage(footage), m_measure(footage.object, *footage.model)
{
}

// A frame from which on as many show the object.
std::size_t DisturbTrials::pick(std::size_t length, vpPoseRandom &random) const
{
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i + length <= m_footage.images.size(); ++i) {
    const auto begin = m_footage.isSeen.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::all_of(begin, begin + static_cast<std::ptrdiff_t>(length), [](bool isSeen) { return isSeen; })) {
      places.push_back(i);
    }
  }
  if (places.empty()) {
    throw vpException(vpException::badValue, "No %zu frames on end show the object", length);
  }
  return places[static_cast<std::size_t>(random.index(places.size()))];
}

// Of the model's points from where they are in the shifted image, pixels, in the mean.
double DisturbTrials::pixelsOff(const vpHomogeneousMatrix &cMo, std::size_t frame, const Shift &shift) const
{
  const vpHomogeneousMatrix &truth = m_footage.truth[frame];
  if (shift.right == 0 && shift.down == 0) {
    return m_measure(cMo, truth, m_footage.cam).pixels;
  }
  const Eigen::Isometry3d estimated = vpPoseExponential::toEigen(cMo);
  const Eigen::Isometry3d right = vpPoseExponential::toEigen(truth);
  const Eigen::Array2d focal(m_footage.cam.get_px(), m_footage.cam.get_py());
  const Eigen::Array2d by(shift.right, shift.down);
  double sum = 0.;
  for (const Eigen::Vector3d &X : m_footage.model->vertices()) {
    const Eigen::Vector3d a = estimated * X;
    const Eigen::Vector3d b = right * X;
    if (!(a.z() > 0.) || !(b.z() > 0.)) {
      return HUGE_VAL;
    }
    const Eigen::Array2d off = focal * (a.head<2>().array() / a.z() - b.head<2>().array() / b.z()) - by;
    sum += off.matrix().norm();
  }
  return sum / static_cast<double>(m_footage.model->vertices().size());
}

void DisturbTrials::judge(const TrackerAnswer &answer, std::size_t frame, const Shift &shift, DisturbCount &count) const
{
  const bool isShifted = shift.right != 0 || shift.down != 0;
  const double pixels = pixelsOff(answer.cMo, frame, shift);
  const bool isRight = pixels < (isShifted ? shiftedFactor : 1.) * m_options.right;
  const bool isTracking = answer.state == vpTrackingState::TRACKING;
  ++count.trials;
  count.right += isRight ? 1 : 0;
  count.rightTracking += isRight && isTracking ? 1 : 0;
  count.wrongTracking += !isRight && isTracking ? 1 : 0;
  count.pixels.push_back(pixels);
}

std::unique_ptr<BenchTracker> DisturbTrials::make(const std::string &tracker) const
{
  return makeTracker(tracker, m_footage.object, m_footage.cam, m_options.config);
}

DisturbCount DisturbTrials::starts(const std::string &tracker, int offset) const
{
  const std::size_t length = static_cast<std::size_t>(m_options.frames);
  const std::unique_ptr<BenchTracker> following = make(tracker); // A start forgets what was before.
  DisturbCount count;
  for (int trial = 0; trial < m_options.trials; ++trial) {
    vpPoseRandom random(static_cast<std::uint64_t>(m_options.seed),
                        {static_cast<std::uint64_t>(trial), static_cast<std::uint64_t>(offset)});
    const std::size_t frame = pick(length, random);
    const vpHomogeneousMatrix start =
        offBy(offset, m_footage.truth[frame], *m_footage.model, m_measure, m_footage.cam, random);
    count.startMs.push_back(timed([&] { following->init(m_footage.images[frame], start); }));
    for (std::size_t i = 0; i < length; ++i) {
      const double ms = timed([&] { following->track(m_footage.images[frame + i]); });
      if (i == 0) {
        count.ms.push_back(ms);
      }
    }
    judge(following->answer(), frame + length - 1, {}, count);
  }
  return count;
}

// Follows the object, and on in images that are shifted.
void DisturbTrials::runShift(BenchTracker &tracker, std::size_t first, const Shift &by, DisturbCount &count) const
{
  const std::size_t length = framesBefore + static_cast<std::size_t>(m_options.framesAfter);
  count.startMs.push_back(timed([&] { tracker.init(m_footage.images[first], m_footage.truth[first]); }));
  BenchImage shifted;
  for (std::size_t i = 0; i < length; ++i) {
    const BenchImage &I = m_footage.images[first + i];
    const Shift now = i < framesBefore ? Shift() : by;
    shifted.isGray = I.isGray;
    shift(I.color, now.right, now.down, shifted.color);
    shift(I.gray, now.right, now.down, shifted.gray);
    const double ms = timed([&] { tracker.track(shifted); });
    if (i == framesBefore) {
      count.ms.push_back(ms);
    }
  }
  judge(tracker.answer(), first + length - 1, by, count);
}

DisturbCount DisturbTrials::shifts(const std::string &tracker) const
{
  const std::size_t length = framesBefore + static_cast<std::size_t>(m_options.framesAfter);
  const std::unique_ptr<BenchTracker> following = make(tracker);
  DisturbCount count;
  for (std::size_t s = 0; s < m_options.shifts.size(); ++s) {
    for (int direction = 0; direction < directions; ++direction) {
      vpPoseRandom random(static_cast<std::uint64_t>(m_options.seed), {s, static_cast<std::uint64_t>(direction), 1});
      const double angle = 2. * M_PI * direction / directions;
      const Shift by = {static_cast<int>(std::lround(m_options.shifts[s] * std::cos(angle))),
                        static_cast<int>(std::lround(m_options.shifts[s] * std::sin(angle)))};
      runShift(*following, pick(length, random), by, count);
    }
  }
  return count;
}

} // namespace bench
