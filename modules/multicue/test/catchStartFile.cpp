// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "renderedBox.h"

#include <fileVariants.h>
#include <meshFiles.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

namespace {
using namespace fileVariants;

struct Fixture
{
  Fixture()
  {
    tracker.setCameraParameters(renderedBox::camera());
    tracker.loadModel(renderedBox::writeCao(folder.path("box.cao")));
    I = box.draw(renderedBox::pose());
  }

  meshFiles::TemporaryFolder folder;
  renderedBox box;
  vpMbMultiCueTracker tracker;
  vpImage<unsigned char> I;
};

std::string poseText()
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(12);
  const vpPoseVector pose(renderedBox::pose());
  for (unsigned int i = 0; i < 6; ++i) {
    text << pose[i] << "\n";
  }
  return text.str();
}
} // namespace

TEST_CASE("A start pose needs all six of its numbers", "[files]")
{
  Fixture f;
  const std::string good = f.folder.write("good.pos", "# a start\n" + poseText());
  const CommaLocale comma;
  f.tracker.initFromPose(f.I, good);
  CHECK((renderedBox::pose().inverse() * f.tracker.getPose()).getTranslationVector().frobeniusNorm() < 1e-9);
  for (const auto &[text, told] : {std::pair<std::string, std::string>{"0 0 0.5 0 0", "5 numbers"},
                                   {"", "0 numbers"},
                                   {"0 0 0.5 0 0 0 1", "follows"},
                                   {"0 0 0,5 0 0 0", "'0,5'"},
                                   {"0 0 nan 0 0 0", "'nan'"},
                                   {"0 0 x", "'x'"}}) {
    CAPTURE(text);
    const std::string file = f.folder.write("bad.pos", text);
    CHECK_THAT(messageOf([&] { f.tracker.initFromPose(f.I, file); }),
               ContainsSubstring("bad.pos") && ContainsSubstring(told));
    const vpImage<vpRGBa> colors(f.I.getHeight(), f.I.getWidth());
    CHECK_THAT(messageOf([&] { f.tracker.initFromPose(colors, file); }), ContainsSubstring("bad.pos"));
  }
  CHECK_THAT(messageOf([&] { f.tracker.initFromPose(f.I, f.folder.path("none")); }), ContainsSubstring("none.pos"));
}

TEST_CASE("Points to start from need all of their numbers", "[files]")
{
  Fixture f;
  const std::string object = "4 # points\n0 0 0\n0.1 0 0\n0 0.1 0\n0.1 0.1 0\n";
  for (const auto &[text, told] : {std::pair<std::string, std::string>{object, "2D points"},
                                   {object + "3\n1 1\n1 2\n2 1\n", "at least 4"},
                                   {"4\n0 0 0\n0.1 0\n0 0.1 0\n0.1 0.1 0\n", "line 3"},
                                   {object + "4\n100 100\n100\n200 100\n200 200\n", "line 8"},
                                   {"90000000\n0 0 0\n", "90000000"},
                                   {object + "5\n100 100\n100 200\n200 100\n200 200\n1 1\n", "as many"}}) {
    CAPTURE(text);
    const std::string file = f.folder.write("bad.init", text);
    CHECK_THAT(messageOf([&] { f.tracker.initFromPoints(f.I, file); }),
               ContainsSubstring("bad.init") && ContainsSubstring(told));
  }
  const std::string file = f.folder.write("click.init", "3\n0 0 0\n0 1 0\n1 0 0\n");
  CHECK_THAT(messageOf([&] { f.tracker.initClick(f.I, file); }), ContainsSubstring("click.init"));
  CHECK_THAT(messageOf([&] { f.tracker.initClick(f.I, f.folder.path("no-clicks")); }),
             ContainsSubstring("no-clicks.init"));
}

TEST_CASE("Start files that are cut off, edited, or saved in another encoding are read rightly or refused", "[files]")
{
  Fixture f;
  f.tracker.setRenderer(vpModelRenderer::Preference::CPU);
  // Words apart from their ends of lines; a number may lose digits without that anybody can tell.
  const std::string pose = "# translation, m\n0.1 -0.05 0.5 # theta u, rad\n0.25 0.5 1\n";
  const auto readPose = [&](const std::string &content) {
    f.tracker.initFromPose(f.I, f.folder.write("variant.pos", content));
    std::ostringstream text;
    text << vpPoseVector(f.tracker.getPose()).t();
    return Outcome{text.str(), false};
  };
  const std::vector<Variant> poses =
      together({encodings(pose), cutsOfNumbers(pose), tokenEdits(pose), byteFlips(pose, 100)});
  CHECK(faults(poses, "variant.pos", readPose(pose).what, readPose) == "");

  const std::string points =
      "4 # points\n0 0 0\n0.1 0 0\n0 0.1 0\n0.1 0.1 0\n4 # pixels\n200 200\n200 300\n300 200\n300 300\n";
  const auto readPoints = [&](const std::string &content) {
    f.tracker.initFromPoints(f.I, f.folder.write("variant.init", content));
    std::ostringstream text;
    text.precision(4);
    text << vpPoseVector(f.tracker.getPose()).t();
    return Outcome{text.str(), false};
  };
  const std::vector<Variant> starts =
      together({encodings(points), cutsOfNumbers(points), tokenEdits(points), byteFlips(points, 100)});
  CHECK(faults(starts, "variant.init", readPoints(points).what, readPoints) == "");
}
