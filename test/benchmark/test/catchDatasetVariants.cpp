// SPDX-License-Identifier: GPL-2.0-or-later
// What becomes of the files of data sets that were cut off, edited, or saved in another encoding.
#include <catchMain.h>

#include "datasetFolder.h"

#include <fileVariants.h>

namespace {
using namespace fileVariants;

// What a data set says: poses, cameras and shares, to the first digits.
std::string textOf(const bench::Sequence &sequence)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  for (const bench::SequenceFrame &frame : sequence.frames) {
    text << frame.id << " " << frame.hasTruth << " " << frame.visibility << " " << frame.cam.get_px() << " "
         << frame.cam.get_py() << " " << frame.cam.get_u0() << " " << frame.cam.get_v0();
    for (unsigned int i = 0; i < 12; ++i) {
      text << " " << frame.cMo.data[i];
    }
    text << "\n";
  }
  text << sequence.object.diameter << " " << sequence.object.symmetry.size() << " " << sequence.object.axis.size();
  return text.str();
}

// A data set of which a file is changed.
class Changed
{
public:
  explicit Changed(void (*put)(const DatasetFolder &)) { put(m_folder); }

  //! \param open Opens what there is in the folder.
  std::string faults(const std::string &file, const std::function<std::vector<Variant>(const std::string &)> &variants,
                     bench::Sequence (*open)(const DatasetFolder &)) const
  {
    const std::string good = m_folder.text(file);
    const auto read = [&](const std::string &content) {
      m_folder.put(file, content);
      const bench::Sequence sequence = open(m_folder);
      return Outcome{textOf(sequence), !sequence.notes.empty()};
    };
    const std::string right = read(good).what;
    const std::string name = std::filesystem::path(file).filename().string();
    const std::string result = fileVariants::faults(variants(good), name, right, read);
    m_folder.put(file, good);
    return result;
  }

private:
  DatasetFolder m_folder;
};

// Words of JSON apart, so that each of them is edited.
std::vector<Variant> ofJson(const std::string &content)
{
  std::string apart;
  for (const char c : content) {
    apart += std::string("{}[]:,").find(c) != std::string::npos ? std::string(" ") + c + " " : std::string(1, c);
  }
  return together({encodings(content), cuts(content), tokenEdits(apart), byteFlips(content, 100)});
}

std::vector<Variant> ofNumbers(const std::string &content)
{
  return together({encodings(content), cutsOfNumbers(content), tokenEdits(content), byteFlips(content, 100)});
}

bench::Sequence openBop(const DatasetFolder &folder)
{
  return bench::openSequence(folder.path(), "test/000001", 5);
}

bench::Sequence openRbot(const DatasetFolder &folder)
{
  return bench::openSequence(folder.path(), "ape/a_regular");
}
} // namespace

TEST_CASE("Files of a BOP scene that are changed are read rightly, with a note, or refused by name", "[files]")
{
  const Changed bop(putBop);
  const std::string scene = "test/000001/";
  CHECK(bop.faults(scene + "scene_gt.json", ofJson, openBop) == "");
  CHECK(bop.faults(scene + "scene_camera.json", ofJson, openBop) == "");
  CHECK(bop.faults(scene + "scene_gt_info.json", ofJson, openBop) == "");
  CHECK(bop.faults("models/models_info.json", ofJson, openBop) == "");
}

TEST_CASE("Files of an RBOT data set that are changed are read rightly or refused by name", "[files]")
{
  const Changed rbot(putRbot);
  CHECK(rbot.faults("poses_first.txt", ofNumbers, openRbot) == "");
  CHECK(rbot.faults("camera_calibration.txt", ofNumbers, openRbot) == "");
}

TEST_CASE("Poses of a recording that are changed are read rightly or refused by name", "[files]")
{
  const Changed recording(putSmallRecording);
  CHECK(recording.faults("pose1.txt", ofNumbers, openSmallRecording) == "");
}

TEST_CASE("Data sets are the same in every locale", "[files]")
{
  const DatasetFolder bop, rbot, recording;
  putBop(bop);
  putRbot(rbot);
  putSmallRecording(recording);
  const std::string right = textOf(openBop(bop)) + textOf(openRbot(rbot)) + textOf(openSmallRecording(recording));
  const CommaLocale comma;
  CHECK(textOf(openBop(bop)) + textOf(openRbot(rbot)) + textOf(openSmallRecording(recording)) == right);
}
