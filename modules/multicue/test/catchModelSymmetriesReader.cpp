// SPDX-License-Identifier: GPL-2.0-or-later
// Symmetries from files in BOP's layout, and what settings say of them.
#include <catchMain.h>

#include "settingsFiles.h"

#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/multicue/vpModelSymmetriesReader.h>

#include <cmath>

namespace {
using settingsFiles::Folder;
using settingsFiles::messageOf;

const std::string halfTurn = "[-1, 0, 0, 10, 0, -1, 0, 20, 0, 0, 1, 0, 0, 0, 0, 1]";
const std::string bop =
    R"({"2": {"diameter": 80.5, "symmetries_continuous": [{"axis": [0, 0, 2], "offset": [0, 30, 0]}]},
  "5": {"diameter": 75, "min_x": -20, "symmetries_discrete": [)" +
    halfTurn + R"(]},
  "7": {"diameter": 75}})";

vpModelSymmetries read(const std::string &text, unsigned int object = 0)
{
  const Folder folder;
  return vpModelSymmetriesReader::read(folder.write("models_info.json", text), object);
}

std::string refusal(const std::string &text, unsigned int object = 0)
{
  return messageOf([&] { read(text, object); });
}

std::string withTurn(const std::string &matrix)
{
  return "{\"5\": {\"symmetries_discrete\": [" + halfTurn + ", " + matrix + "]}}";
}

std::string boxIn(const Folder &folder)
{
  return folder.write("box.stl", meshFiles::asciiStl(modelShapes::boxTriangles(Eigen::Vector3d(0.2, 0.12, 0.08))));
}
} // namespace

TEST_CASE("Symmetries are read from models_info.json, millimetres become metres", "[symmetries]")
{
  const vpModelSymmetries can = read(bop, 2);
  REQUIRE(can.axes().size() == 1);
  CHECK(can.discrete().size() == 1);
  CHECK(can.axes()[0].direction.isApprox(Eigen::Vector3d::UnitZ()));
  CHECK(can.axes()[0].point.isApprox(Eigen::Vector3d(0., 0.03, 0.)));
  const vpModelSymmetries turned = read(bop, 5);
  REQUIRE(turned.discrete().size() == 2);
  CHECK(turned.discrete()[1][0][0] == Approx(-1.));
  CHECK(turned.discrete()[1][0][3] == Approx(0.01));
  CHECK(turned.discrete()[1][1][3] == Approx(0.02));
  CHECK(read(bop, 7).isEmpty());
  CHECK(read("{\"12\": {\"symmetries_discrete\": [" + halfTurn + "]}}").discrete().size() == 2);
}

TEST_CASE("What is wrong in models_info.json is said with its place", "[symmetries]")
{
  CHECK_THAT(messageOf([] { vpModelSymmetriesReader::read("nowhere/models_info.json"); }),
             ContainsSubstring("nowhere/models_info.json") && ContainsSubstring("does not exist"));
  CHECK_THAT(refusal("{\"5\": "), ContainsSubstring("models_info.json") && ContainsSubstring("no JSON"));
  CHECK_THAT(refusal("[1]"), ContainsSubstring("models_info.json") && ContainsSubstring("object {...}"));
  CHECK_THAT(refusal(std::string(100000, '[')), ContainsSubstring("models_info.json") && ContainsSubstring("nested"));
  CHECK_THAT(refusal("{\"5\": {}, \"2\": {}, \"5\": {\"diameter\": 3}}"),
             ContainsSubstring("models_info.json") && ContainsSubstring("'5' is there twice"));
  CHECK_THAT(refusal("{\"5\": 3}"), ContainsSubstring("models_info.json") && ContainsSubstring("3"));
  CHECK_THAT(refusal(bop, 3), ContainsSubstring("no object 3") && ContainsSubstring("2, 5, 7"));
  CHECK_THAT(refusal(bop), ContainsSubstring("number is needed") && ContainsSubstring("2, 5, 7"));
  const std::string place = "'symmetries_discrete', [1]";
  CHECK_THAT(refusal(withTurn("[1, 0, 0]"), 5),
             ContainsSubstring("object 5") && ContainsSubstring(place) && ContainsSubstring("16"));
  CHECK_THAT(refusal(withTurn("[-2, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]"), 5),
             ContainsSubstring(place) && ContainsSubstring("rotation"));
  CHECK_THAT(refusal(withTurn("[-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1]"), 5),
             ContainsSubstring(place) && ContainsSubstring("last row"));
  CHECK_THAT(refusal(withTurn("\"half\""), 5), ContainsSubstring(place) && ContainsSubstring("half"));
  CHECK_THAT(refusal(R"({"5": {"symmetries_discrete": 1}})"), ContainsSubstring("a list is needed"));
  CHECK_THAT(refusal(R"({"5": {"symmetries_continuous": [{"offset": [0, 0, 0]}]}})"), ContainsSubstring("'axis'"));
  CHECK_THAT(refusal(R"({"5": {"symmetries_continuous": [{"axis": [0, 0]}]}})"), ContainsSubstring("3 numbers"));
  CHECK_THAT(refusal(R"({"5": {"symmetries_continuous": [{"axis": [0, 0, 0]}]}})"),
             ContainsSubstring("'symmetries_continuous', [0]") && ContainsSubstring("direction"));
}

TEST_CASE("Settings have a tracker find symmetries, read them, or have none", "[symmetries]")
{
  const Folder folder;
  folder.write("models_info.json", bop);
  const std::string find = folder.write("find.json", R"({"symmetries": {"from": "find"}})");
  const std::string file = folder.write("file.json", R"({"symmetries": {"from": "models_info.json", "object": 5}})");
  const std::string none = folder.write("none.json", R"({"symmetries": {"from": "none"}})");
  const std::string other = folder.write("other.json", R"({"search": true})");
  vpMbMultiCueTracker tracker;
  CHECK(tracker.getSymmetries().isEmpty());
  tracker.loadConfigFile(find, false);
  CHECK(tracker.getSymmetries().isEmpty()); // There is no model yet.
  tracker.loadModel(boxIn(folder));
  CHECK(tracker.getSymmetries().discrete().size() == 4);
  tracker.loadConfigFile(other, false);
  CHECK(tracker.getSymmetries().discrete().size() == 4);
  tracker.loadConfigFile(file, false);
  CHECK(tracker.getSymmetries().discrete().size() == 2);
  tracker.loadConfigFile(none, false);
  CHECK(tracker.getSymmetries().isEmpty());
  tracker.setSymmetries(read(bop, 2));
  tracker.loadConfigFile(other, false);
  CHECK(tracker.getSymmetries().axes().size() == 1);
  tracker.loadConfigFile(find, false);
  CHECK(tracker.getSymmetries().discrete().size() == 4);
  tracker.resetTracker();
  CHECK(tracker.getSymmetries().isEmpty());
}

TEST_CASE("A file of symmetries that is missing leaves the tracker as it was", "[symmetries]")
{
  const Folder folder;
  const std::string file = folder.write("file.json", R"({"search": true, "symmetries": {"from": "gone.json"}})");
  vpMbMultiCueTracker tracker;
  tracker.setSymmetries(read(bop, 5));
  CHECK_THAT(messageOf([&] { tracker.loadConfigFile(file, false); }), ContainsSubstring("gone.json"));
  CHECK(tracker.getSymmetries().discrete().size() == 2);
  CHECK_THAT(
      messageOf([&] { tracker.loadConfigFile(folder.write("bad.json", R"({"symmetries": {"from": 3}})"), false); }),
      ContainsSubstring("symmetries.from") && ContainsSubstring("\"find\""));
}

TEST_CASE("A path in settings is meant from their folder and written as a whole", "[symmetries]")
{
  const Folder folder;
  folder.write("models_info.json", bop);
  const vpMultiCueSettings settings = vpMultiCueSettingsReader::read(
      folder.write("file.json", R"({"symmetries": {"from": "models_info.json", "object": 5}})"), vpMultiCueSettings());
  CHECK(vpModelSymmetriesReader::read(settings.symmetries, settings.symmetricObject).discrete().size() == 2);
  const Folder elsewhere;
  const std::string copy = elsewhere.path("copy.json");
  vpMultiCueSettingsReader::write(copy, settings);
  const vpMultiCueSettings again = vpMultiCueSettingsReader::read(copy, vpMultiCueSettings());
  CHECK(again.symmetries == settings.symmetries);
  CHECK(again.symmetricObject == 5);
}
