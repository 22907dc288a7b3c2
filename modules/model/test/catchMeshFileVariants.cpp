// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "fileVariants.h"
#include "meshFiles.h"

#include <visp3/model/vpModelReader.h>

namespace {
using namespace fileVariants;

// A coloured tetrahedron, small enough for all variants of all words.
const char *const objText = "# made by hand\nmtllib skin.mtl\no thing\nv 0 0 0\nv 0.2 0 0\nv 0 0.3 0\nv 0 0 0.4\n"
                            "usemtl red\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
const char *const mtlText = "newmtl red\nNs 10\nKd 1 0 0\n";
const char *const plyText = "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\n"
                            "property float y\nproperty float z\nelement face 4\n"
                            "property list uchar int vertex_indices\nend_header\n0 0 0\n0.2 0 0\n0 0.3 0\n0 0 0.4\n"
                            "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

meshFiles::Triangles tetrahedron()
{
  const modelShapes::Point o(0., 0., 0.), x(0.2, 0., 0.), y(0., 0.3, 0.), z(0., 0., 0.4);
  return {{{o, y, x}}, {{o, x, z}}, {{x, y, z}}, {{y, o, z}}};
}

std::string binaryPly(bool bigEndian)
{
  std::string text = plyText;
  text.resize(text.find("end_header\n") + 11);
  text.replace(text.find("ascii"), 5, bigEndian ? "binary_big_endian" : "binary_little_endian");
  const auto add = [&](auto number) {
    std::string bytes;
    meshFiles::append(bytes, number);
    if (bigEndian) {
      std::reverse(bytes.begin(), bytes.end());
    }
    text += bytes;
  };
  for (const float coordinate : {0.F, 0.F, 0.F, 0.2F, 0.F, 0.F, 0.F, 0.3F, 0.F, 0.F, 0.F, 0.4F}) {
    add(coordinate);
  }
  for (const std::array<int, 3> &face : {std::array<int, 3>{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}) {
    add(static_cast<unsigned char>(3));
    for (const int index : face) {
      add(static_cast<std::int32_t>(index));
    }
  }
  return text;
}

std::string gltfText()
{
  const std::string node = ",\"translation\":[0, 0, 0]";
  return meshFiles::gltfJson(tetrahedron(), "\"uri\":\"four.bin\",", node);
}

struct Format
{
  std::string extension;
  std::string content;
  std::size_t stride; // Every so many words are edited.
};

std::vector<Format> formats()
{
  return {{"obj", objText, 1},
          {"ply", plyText, 1},
          {"stl", meshFiles::asciiStl(tetrahedron()), 1},
          {"dae", meshFiles::dae(tetrahedron(), "<unit meter=\"1\"/>"), 1},
          {"gltf", gltfText(), 1}};
}

// Words of JSON and XML are not between blanks.
std::string spread(const Format &format)
{
  std::string result;
  for (const char c : format.content) {
    const bool json = format.extension == "gltf" && std::string("{}[]:,").find(c) != std::string::npos;
    const bool xml = format.extension == "dae" && c == '>';
    result += json ? std::string(" ") + c + " " : xml ? "> " : std::string(1, c);
  }
  return result;
}

class Reader
{
public:
  Reader() { m_folder.write("skin.mtl", mtlText), m_folder.write("four.bin", meshFiles::floats(tetrahedron())); }
  vpTrackedModel read(const std::string &extension, const std::string &content) const
  {
    return vpModelReader::read(m_folder.write("variant." + extension, content));
  }
  // \return What all variants end with that they should not.
  std::string faults(const std::string &extension, const std::string &right, const std::vector<Variant> &variants) const
  {
    return fileVariants::faults(variants, "variant." + extension, right,
                                [&](const std::string &content) { return outcomeOf(read(extension, content)); });
  }
  // The same for a file that a mesh refers to.
  std::string faultsBeside(const Format &format, const std::string &file, const std::string &good,
                           const std::vector<Variant> &variants) const
  {
    m_folder.write(file, good);
    const std::string right = shapeOf(read(format.extension, format.content));
    const std::string mesh = m_folder.path("variant." + format.extension);
    return fileVariants::faults(variants, format.extension, right, [&](const std::string &content) {
      m_folder.write(file, content);
      return outcomeOf(vpModelReader::read(mesh));
    });
  }

private:
  meshFiles::TemporaryFolder m_folder;
};
} // namespace

TEST_CASE("Meshes that are cut off anywhere are refused, or the report warns", "[files]")
{
  const Reader reader;
  for (const Format &format : formats()) {
    const std::string right = shapeOf(reader.read(format.extension, format.content));
    CHECK(reader.faults(format.extension, right, cuts(format.content)) == "");
    CHECK(right.find("0.2 0.3 0.4 m") == 0);
  }
}

TEST_CASE("Binary meshes that are cut off or changed anywhere are refused, or read", "[files]")
{
  const Reader reader;
  for (const auto &[extension, content] : {std::pair<std::string, std::string>{"ply", binaryPly(false)},
                                           {"ply", binaryPly(true)},
                                           {"stl", meshFiles::binaryStl(tetrahedron())},
                                           {"glb", meshFiles::glb(tetrahedron())}}) {
    const std::string right = shapeOf(reader.read(extension, content));
    CHECK(right.find("0.2 0.3 0.4 m") == 0);
    CHECK(reader.faults(extension, right, cuts(content)) == "");
    CHECK(reader.faults(extension, right, byteFlips(content, 400)) == "");
  }
}

TEST_CASE("Meshes with other bytes are read, or refused by name", "[files]")
{
  const Reader reader;
  for (const Format &format : formats()) {
    CHECK(reader.faults(format.extension, "", byteFlips(format.content, 400)) == "");
  }
}

TEST_CASE("Meshes of which a word is changed are read rightly, with a warning, or refused", "[files]")
{
  const Reader reader;
  for (const Format &format : formats()) {
    const std::string content = spread(format);
    const std::string right = shapeOf(reader.read(format.extension, content));
    CHECK(reader.faults(format.extension, right, tokenEdits(content, format.stride)) == "");
  }
}

TEST_CASE("Meshes are the same in every locale, however their lines end, and behind a byte order mark", "[files]")
{
  const Reader reader;
  for (const Format &format : formats()) {
    CAPTURE(format.extension);
    const std::string right = shapeOf(reader.read(format.extension, format.content));
    for (const Variant &variant : encodings(format.content)) {
      if (variant.what.find("UTF-16") == std::string::npos) {
        CAPTURE(variant.what);
        CHECK(shapeOf(reader.read(format.extension, variant.content)) == right);
      }
    }
    CHECK(reader.faults(format.extension, right, encodings(format.content)) == "");
    const CommaLocale comma;
    CHECK(shapeOf(reader.read(format.extension, format.content)) == right);
    CHECK(CommaLocale::isGlobal());
  }
}

TEST_CASE("What a mesh refers to is read rightly, missed with a warning, or refused", "[files]")
{
  const Reader reader;
  const Format obj = formats().front();
  const Format gltf = formats().back();
  CHECK(reader.read("obj", obj.content).appearance().color.size() == 4);
  CHECK(reader.faultsBeside(obj, "skin.mtl", mtlText, encodings(mtlText)) == "");
  CHECK(reader.faultsBeside(obj, "skin.mtl", mtlText, cuts(mtlText)) == "");
  CHECK(reader.faultsBeside(obj, "skin.mtl", mtlText, tokenEdits(mtlText)) == "");
  CHECK(reader.faultsBeside(obj, "skin.mtl", mtlText, byteFlips(mtlText, 400)) == "");
  const std::string data = meshFiles::floats(tetrahedron());
  CHECK(reader.faultsBeside(gltf, "four.bin", data, cuts(data)) == "");
  CHECK(reader.faultsBeside(gltf, "four.bin", data, byteFlips(data, 400)) == "");
}
