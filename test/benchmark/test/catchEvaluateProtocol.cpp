// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "evaluate/protocol.h"
#include "evaluate/startPoses.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>
#include <visp3/model/vpTrackedModelBuilder.h>

#include <opencv2/imgcodecs.hpp>

namespace {
using bench::Protocol;

// Says a pose that is off by a shift which grows with every frame since the start.
class DriftingTracker : public bench::BenchTracker
{
public:
  void init(const bench::BenchImage &, const vpHomogeneousMatrix &cMo) override
  {
    m_start = cMo;
    startPoses.push_back(cMo);
    m_shift = 0.;
    ++starts;
  }
  void track(const bench::BenchImage &I) override
  {
    REQUIRE(I.gray.getWidth() == 32);
    REQUIRE(I.color.getWidth() == 32);
    m_shift += 0.019;
  }
  bench::TrackerAnswer answer() override
  {
    bench::TrackerAnswer answer;
    answer.cMo = vpHomogeneousMatrix(m_shift, 0., 0., 0., 0., 0.) * m_start;
    answer.state = vpTrackingState::TRACKING;
    return answer;
  }

  int starts = 0;
  std::vector<vpHomogeneousMatrix> startPoses;

private:
  vpHomogeneousMatrix m_start;
  double m_shift = 0.;
};

vpTrackedModel square()
{
  vpTrackedModelBuilder builder;
  builder.addFace({{-0.05, -0.05, 0.}, {0.05, -0.05, 0.}, {0.05, 0.05, 0.}, {-0.05, 0.05, 0.}});
  return builder.build("square");
}

bench::Sequence still(const meshFiles::TemporaryFolder &folder, int count)
{
  bench::Sequence sequence;
  sequence.scene = "still";
  sequence.object.diameter = 0.2;
  for (int i = 0; i < count; ++i) {
    bench::SequenceFrame frame;
    frame.id = 10 + i;
    frame.image = folder.path(std::to_string(i) + ".png");
    frame.cam = vpCameraParameters(30., 30., 16., 12.);
    frame.hasTruth = true;
    frame.cMo = vpHomogeneousMatrix(0., 0., 0.5, 0., 0., 0.);
    cv::imwrite(frame.image, cv::Mat(24, 32, CV_8UC3, cv::Scalar(10, 20, 30)));
    sequence.frames.push_back(frame);
  }
  return sequence;
}

std::vector<bench::FrameRecord> run(const bench::Sequence &sequence, DriftingTracker &tracker, Protocol protocol,
                                    int step)
{
  bench::ImageStore images(sequence);
  const bench::PoseErrorMeasure measure(sequence.object, square());
  return bench::runProtocol(sequence, images, tracker, measure, protocol, step, [] {});
}
} // namespace

TEST_CASE("Protocol rbot starts the tracker again after each failure", "[evaluate]")
{
  const meshFiles::TemporaryFolder folder;
  DriftingTracker tracker;
  const auto records = run(still(folder, 10), tracker, Protocol::RBOT, 1);
  REQUIRE(records.size() == 9);
  // 19 and 38 mm pass, 57 mm fails.
  for (std::size_t i = 0; i < records.size(); ++i) {
    CHECK(records[i].frame == 11 + static_cast<int>(i));
    CHECK(records[i].success == (i % 3 != 2));
    CHECK(records[i].reset == (i % 3 == 2));
    CHECK(records[i].right == (i % 3 == 0)); // Within 20 mm, a tenth of the diameter.
  }
  CHECK(tracker.starts == 4);
}

TEST_CASE("Starts are as many pixels off as asked for, after failures too, and the same for the same seed",
          "[evaluate]")
{
  const meshFiles::TemporaryFolder folder;
  const bench::Sequence sequence = still(folder, 10);
  const vpTrackedModel model = square();
  const bench::PoseErrorMeasure measure(sequence.object, model);
  const auto startsWith = [&](double pixels, int seed) {
    const bench::StartPoses poses{pixels, seed};
    bench::ImageStore images(sequence);
    DriftingTracker tracker;
    bench::runProtocol(
        sequence, images, tracker, measure, Protocol::RBOT, 1, [] {},
        [&](const bench::SequenceFrame &frame) { return poses.at("still", frame, model, measure); });
    return tracker.startPoses;
  };
  const std::vector<vpHomogeneousMatrix> starts = startsWith(1.5, 1);
  REQUIRE(starts.size() > 2);
  for (const vpHomogeneousMatrix &cMo : starts) {
    CHECK(measure(cMo, sequence.frames[0].cMo, sequence.frames[0].cam).pixels == Approx(1.5).margin(1e-3));
  }
  CHECK(starts[1][0][3] != exactly(starts[0][0][3]));
  CHECK(startsWith(1.5, 1).front()[0][3] == exactly(starts.front()[0][3]));
  CHECK(startsWith(1.5, 2).front()[0][3] != exactly(starts.front()[0][3]));
  CHECK(startsWith(0., 1).front()[0][3] == exactly(sequence.frames[0].cMo[0][3]));
}

TEST_CASE("Protocol run starts the tracker once", "[evaluate]")
{
  const meshFiles::TemporaryFolder folder;
  DriftingTracker tracker;
  const auto records = run(still(folder, 10), tracker, Protocol::RUN, 2);
  REQUIRE(records.size() == 4);
  CHECK(records[0].frame == 12);
  CHECK(records[3].frame == 18);
  CHECK(records[1].success);
  CHECK_FALSE(records[2].success);
  CHECK_FALSE(records[2].reset);
  CHECK_FALSE(records[3].success);
  CHECK(tracker.starts == 1);
}

TEST_CASE("Frames that hardly show the object count nowhere and restart nothing", "[evaluate]")
{
  const meshFiles::TemporaryFolder folder;
  bench::Sequence sequence = still(folder, 6);
  for (std::size_t i = 2; i < 5; ++i) {
    sequence.frames[i].visibility = 0.1;
  }
  DriftingTracker tracker;
  const auto records = run(sequence, tracker, Protocol::RBOT, 1);
  CHECK(records[0].counted);
  CHECK_FALSE(records[1].counted);
  CHECK_FALSE(records[2].reset);
  CHECK_FALSE(records[3].counted);
  CHECK(records[4].counted);
  CHECK(records[4].reset);
}

TEST_CASE("A large object may be off by a tenth of its diameter", "[evaluate]")
{
  CHECK(bench::Limits(0.2).successTranslation == Approx(0.05));
  CHECK(bench::Limits(2.).successTranslation == Approx(0.2));
  CHECK(bench::Limits(2.).rightTranslation == Approx(0.2));
}

TEST_CASE("An image that is broken or of another size is named", "[evaluate]")
{
  const meshFiles::TemporaryFolder folder;
  const bench::Sequence sequence = still(folder, 4);
  DriftingTracker tracker;
  SECTION("broken")
  {
    folder.write("2.png", "no picture");
    CHECK_THROWS_WITH(run(sequence, tracker, Protocol::RUN, 1), ContainsSubstring("2.png"));
  }
  SECTION("of another size")
  {
    cv::imwrite(folder.path("3.png"), cv::Mat(24, 33, CV_8UC3));
    CHECK_THROWS_WITH(run(sequence, tracker, Protocol::RUN, 1), ContainsSubstring("3.png"));
  }
}
