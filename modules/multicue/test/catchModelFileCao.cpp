// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>
#include <processorTime.h>

#include <fileVariants.h>
#include <meshFiles.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

namespace {
using namespace fileVariants;

const std::string points = "V1\n# points\n5\n0 0 0\n0.2 0 0\n0 0.3 0\n0 0 0.4\n0.5 0.5 0.5\n";
// One line of its own, a face of lines, three of points, a cylinder and a circle.
const std::string whole = points + "4 # lines\n0 4\n0 1\n1 2\n2 0\n1\n3 1 2 3 name=\"bottom\" useLod=true\n"
                                   "3 # faces\n3 0 1 3\n3 1 2 3 name=side minPolygonAreaThreshold=20\n3 2 0 3 # last\n"
                                   "1\n0 3 0.05 name=\"post # 1\"\n1\n0.06 4 1 2\n";

vpTrackedModel read(const std::string &file)
{
  vpMbMultiCueTracker tracker;
  tracker.setRenderer(vpModelRenderer::Preference::CPU);
  tracker.loadModel(file);
  return *tracker.getModel();
}

class Folder : public meshFiles::TemporaryFolder
{
public:
  vpTrackedModel readText(const std::string &content) const { return read(write("variant.cao", content)); }

  std::string messageOf(const std::string &content) const
  {
    return ::messageOf([&] { readText(content); });
  }

  std::string faults(const std::string &right, const std::vector<Variant> &variants) const
  {
    return fileVariants::faults(variants, "variant.cao", right,
                                [&](const std::string &content) { return outcomeOf(readText(content)); });
  }
};
} // namespace

TEST_CASE("All sections of a .cao file are read", "[files]")
{
  const Folder folder;
  const vpTrackedModel model = folder.readText(whole);
  CHECK(model.report().cylinders == 1);
  CHECK(model.report().circles == 1);
  CHECK(model.report().edges == 7); // Six of the tetrahedron and the line.
  CHECK(model.report().warnings.empty());
  CHECK(std::any_of(model.faces().begin(), model.faces().end(),
                    [](const vpModelFace &face) { return face.name == "post # 1"; }));
}

TEST_CASE("A .cao file with a wrong count, index or number is refused with the line", "[files]")
{
  const Folder folder;
  const std::string box = points + "0\n0\n4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n0\n0\n";
  CHECK(folder.readText(box).report().closed);
  const auto edited = [&](const std::string &from, const std::string &to) {
    std::string text = box;
    return folder.messageOf(text.replace(text.rfind(from), from.size(), to));
  };
  CHECK_THAT(edited("\n4\n", "\n6\n"), ContainsSubstring("variant.cao") && ContainsSubstring("line 16"));
  CHECK_THAT(edited("\n4\n", "\n3\n"), ContainsSubstring("line 15") && ContainsSubstring("too small"));
  CHECK_THAT(edited("3 2 0 3", "0"), ContainsSubstring("line 15") && ContainsSubstring("0 points"));
  CHECK_THAT(edited("3 2 0 3", "3 2 0 99"), ContainsSubstring("line 15") && ContainsSubstring("index 99"));
  CHECK_THAT(edited("3 2 0 3", "3 2 0 -1"), ContainsSubstring("line 15") && ContainsSubstring("-1"));
  CHECK_THAT(edited("3 2 0 3", "3 2 0"), ContainsSubstring("line 15") && ContainsSubstring("too few"));
  CHECK_THAT(edited("0 0.3 0", "0 0,3 0"), ContainsSubstring("line 6") && ContainsSubstring("decimal comma"));
  CHECK_THAT(edited("\n5\n", "\n405911\n"), ContainsSubstring("line 3") && ContainsSubstring("too many points"));
  CHECK_THAT(edited("V1", "v1"), ContainsSubstring("line 1"));
  CHECK_THAT(folder.messageOf("\xFF\xFEV1"), ContainsSubstring("UTF-16"));
}

TEST_CASE("Ends of lines and a byte order mark do not change a .cao file", "[files]")
{
  const Folder folder;
  const std::string right = shapeOf(folder.readText(whole));
  CHECK(shapeOf(folder.readText("\xEF\xBB\xBF" + whole)) == right);
  CHECK(shapeOf(folder.readText(whole.substr(0, whole.size() - 1))) == right);
  for (const std::string end : {"\r\n", "\r", "\n\n", " \n"}) {
    std::string content;
    for (const char c : whole) {
      content += c == '\n' ? end : std::string(1, c);
    }
    CHECK(shapeOf(folder.readText(content)) == right);
  }
}

TEST_CASE("A .cao file is the same in every locale", "[files]")
{
  const Folder folder;
  const std::string right = shapeOf(folder.readText(whole));
  const CommaLocale comma;
  CHECK(shapeOf(folder.readText(whole)) == right);
  CHECK(CommaLocale::isGlobal());
}

TEST_CASE("A .cao file that is cut off or of which a word is changed is read rightly, with a warning, or refused",
          "[files]")
{
  const Folder folder;
  const std::string right = shapeOf(folder.readText(whole));
  CHECK(folder.faults(right, cuts(whole)) == "");
  CHECK(folder.faults(right, tokenEdits(whole, 2)) == "");
  CHECK(folder.faults(right, encodings(whole)) == "");
  CHECK(folder.faults(right, byteFlips(whole, 100)) == "");
}

TEST_CASE("Parts that a .cao file loads are placed, and may not lead back to it", "[files]")
{
  const Folder folder;
  folder.write("part.cao", points + "0\n0\n4\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n0\n0\n");
  const vpTrackedModel moved = folder.readText("V1\nload(\"part.cao\", t=[1; 0; 0], tu=[0; 0; 90 deg])\n");
  CHECK((moved.report().centreOffset - modelShapes::Point(0.85, 0.1, 0.2)).norm() < 1e-9);
  CHECK(folder.readText("V1\nload(\"part.cao\")\nload(\"part.cao\", t=[1; 0; 0])\n").triangles().size() == 8);
  for (const std::string line : {"load(\"variant.cao\")", "load(\"none.cao\")", "load(part.cao)",
                                 "load(\"part.cao\", t=[1; 0])", "load(\"part.cao\", t=[1,5; 0; 0])",
                                 "load(\"part.cao\", scale=[1; 0; 0])", "load(\"part.cao\"", "lod(\"part.cao\")"}) {
    CAPTURE(line);
    CHECK_THAT(folder.messageOf("V1\n" + line + "\n"), ContainsSubstring("variant.cao") && ContainsSubstring("line 2"));
  }
  folder.write("broken.cao", "V1\n1\n0 0\n");
  CHECK_THAT(folder.messageOf("V1\nload(\"broken.cao\")\n"),
             ContainsSubstring("broken.cao") && ContainsSubstring("line 3"));
  for (int i = 1; i < 25; ++i) {
    const std::string one = "load(\"part" + std::to_string(i - 1) + ".cao\")\n";
    folder.write("part" + std::to_string(i) + ".cao", "V1\n" + one + one);
  }
  std::string many = "V1\n";
  for (int i = 0; i < 9000; ++i) {
    many += "load(\"large.cao\")\n";
  }
  std::string large = points + "0\n0\n100\n";
  for (int i = 0; i < 100; ++i) {
    large += "3 0 2 1\n";
  }
  folder.write("large.cao", large + "0\n0\n");
  {
    const MemoryLimit limit(std::size_t(1) << 30U);
    CHECK_THAT(folder.messageOf(many), ContainsSubstring("variant.cao") && ContainsSubstring("more than 150000"));
  }
  folder.write("part0.cao", "V1\nload(\"part.cao\")\n");
  CHECK_THAT(folder.messageOf("V1\nload(\"part24.cao\")\n"), ContainsSubstring("variant.cao"));
}

TEST_CASE("A .cao file of twenty thousand faces is read in seconds", "[files]")
{
  const Folder folder;
  constexpr int side = 101;
  std::ostringstream text;
  text << "V1\n" << side * side << "\n";
  for (int i = 0; i < side * side; ++i) {
    text << 0.001 * (i / side) << " " << 0.001 * (i % side) << " " << 0.0001 * ((i * i) % 7) << "\n";
  }
  text << "0\n0\n" << 2 * (side - 1) * (side - 1) << "\n";
  for (int i = 0; i + 1 < side; ++i) {
    for (int j = 0; j + 1 < side; ++j) {
      const int corner = i * side + j;
      text << "3 " << corner << " " << corner + side << " " << corner + side + 1 << "\n";
      text << "3 " << corner << " " << corner + side + 1 << " " << corner + 1 << "\n";
    }
  }
  text << "0\n0\n";
  const double start = processorTime();
  CHECK(folder.readText(text.str()).triangles().size() == 20000);
  // It takes a tenth of that, and took minutes.
  CHECK(processorTime() - start < 20.);
}
