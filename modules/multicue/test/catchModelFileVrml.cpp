// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include <fileVariants.h>
#include <meshFiles.h>

#include <visp3/multicue/vpMbMultiCueTracker.h>

#ifdef VISP_HAVE_COIN3D
namespace {
using namespace fileVariants;

const std::string start = "#VRML V2.0 utf8\n";
const std::string coord = "coord Coordinate { point [ 0 0 0, 0.2 0 0, 0 0.3 0, 0 0 0.4 ] }";
const std::string indices = "coordIndex [ 0 2 1 -1, 0 1 3 -1, 1 2 3 -1, 2 0 3 -1 ]";

std::string shape(const std::string &fields)
{
  return "Shape { geometry IndexedFaceSet { " + fields + " } }";
}

std::string group(const std::string &children)
{
  return "Group { children [ " + children + " ] }\n";
}

class Folder : public meshFiles::TemporaryFolder
{
public:
  vpTrackedModel readText(const std::string &content) const
  {
    vpMbMultiCueTracker tracker;
    tracker.setRenderer(vpModelRenderer::Preference::CPU);
    tracker.loadModel(write("variant.wrl", content));
    return *tracker.getModel();
  }

  std::string messageOf(const std::string &content) const
  {
    return ::messageOf([&] { readText(content); });
  }
};
} // namespace

TEST_CASE("A .wrl file without points, or with indices beyond them, is refused", "[files]")
{
  const Folder folder;
  CHECK(folder.readText(start + group(shape(coord + " " + indices))).report().closed);
  CHECK_THAT(folder.messageOf(start + group(shape(indices))),
             ContainsSubstring("variant.wrl") && ContainsSubstring("no points"));
  for (const std::string bad : {"4", "90000000", "-2", "2147483647"}) {
    CHECK_THAT(folder.messageOf(start + group(shape(coord + " coordIndex [ 0 2 1 -1, 0 1 " + bad + " -1 ]"))),
               ContainsSubstring("variant.wrl") && ContainsSubstring("index " + bad));
  }
  const std::string old = "#VRML V1.0 ascii\nSeparator { Coordinate3 { point [ 0 0 0, 0.2 0 0, 0 0.3 0 ] } "
                          "IndexedFaceSet { coordIndex [ 0, 1, 2, -1 ] } }\n";
  CHECK(folder.readText(old).triangles().size() == 1);
  std::string beyond = old;
  CHECK_THAT(folder.messageOf(beyond.replace(beyond.find("2, -1"), 1, "7")), ContainsSubstring("index 7"));
}

TEST_CASE("What ViSP would leave out of a .wrl file, or misplace, is refused", "[files]")
{
  const Folder folder;
  const std::string box = shape(coord + " " + indices);
  CHECK_THAT(folder.messageOf(start + group(box + " Shape { geometry Box { } }")), ContainsSubstring("Box"));
  CHECK_THAT(folder.messageOf(start + group(box + " Anchor { children [ " + box + " ] }")),
             ContainsSubstring("Anchor"));
  CHECK_THAT(folder.messageOf(start + group(shape(coord + " coordIndex [ 0 2 1 -1, 0 1 3 ]"))),
             ContainsSubstring("-1"));
  CHECK_THAT(folder.messageOf(start + group(shape(coord + " coordIndex [ 0 2 1 -1, 3 -1 ]"))),
             ContainsSubstring("one corner"));
  CHECK_THAT(folder.messageOf(start + "Transform { center 1 0 0 rotation 0 0 1 1 children [ " + box + " ] }"),
             ContainsSubstring("center"));
  CHECK_THAT(folder.messageOf(start + group("Inline { url \"variant.wrl\" } " + box)), ContainsSubstring("Inline"));
  CHECK_NOTHROW(folder.readText(start + group("Viewpoint { } DirectionalLight { } " + box)));
}

TEST_CASE("A .wrl file that contains itself, is nested deeply, or multiplies, is refused", "[files]")
{
  const Folder folder;
  const std::string box = shape(coord + " " + indices);
  CHECK_THAT(folder.messageOf(start + "DEF A Group { children [ USE A " + box + " ] }"),
             ContainsSubstring("variant.wrl"));
  std::string deep;
  for (int i = 0; i < 20000; ++i) {
    deep += "Group { children [ ";
  }
  CHECK_THAT(folder.messageOf(start + deep + box), ContainsSubstring("line 2") && ContainsSubstring("nested"));
  std::string many = "DEF A0 " + group(box);
  for (int i = 1; i < 40; ++i) {
    const std::string one = "USE A" + std::to_string(i - 1) + " ";
    many += "DEF A" + std::to_string(i) + " " + group(one + one);
  }
  CHECK_THAT(folder.messageOf(start + many), ContainsSubstring("variant.wrl"));
}

TEST_CASE("A .wrl file that is cut off or of which a word is changed does no harm", "[files]")
{
  const Folder folder;
  const std::string content =
      start + "Transform { translation 0.1 0 0 children [ " + shape(coord + " " + indices) + " ] }\n";
  const std::string right = shapeOf(folder.readText(content));
  std::vector<Variant> variants = cuts(content);
  for (Variant &variant : tokenEdits(content)) {
    // Coin passes over a number too many at the end of a list, and takes other words for names of fields.
    variant.sameNumbers = variant.sameNumbers && variant.what.find("twice") == std::string::npos;
    variants.push_back(std::move(variant));
  }
  for (Variant &variant : encodings(content)) {
    variants.push_back(std::move(variant));
  }
  for (Variant &variant : byteFlips(content, 100)) {
    variants.push_back(std::move(variant));
  }
  CHECK(faults(variants, "variant.wrl", right,
               [&](const std::string &text) { return outcomeOf(folder.readText(text)); }) == "");
  const CommaLocale comma;
  CHECK(shapeOf(folder.readText(content)) == right);
}
#endif
