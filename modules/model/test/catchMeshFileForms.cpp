// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>
#include <processorTime.h>

#include "fileVariants.h"
#include "meshFiles.h"

#include <visp3/model/vpModelReader.h>

#include <cmath>

// Forms of .obj, .ply and .stl files that are valid, or that other readers put up with.

namespace {
const std::string points = "v 0 0 0\nv 0.2 0 0\nv 0 0.3 0\nv 0 0 0.4\n";
const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

std::string messageOfFile(const std::string &file)
{
  return messageOf([&file] { vpModelReader::read(file); });
}

void requireTetrahedron(const vpTrackedModel &model)
{
  CHECK(model.triangles().size() == 4);
  CHECK(model.edges().size() == 6);
  CHECK(model.report().closed);
  CHECK((model.report().size - modelShapes::Point(0.2, 0.3, 0.4)).norm() < 1e-6);
}

std::string plyHeader(const std::string &vertices, const std::string &faceElement, const std::string &before = "")
{
  return "ply\nformat ascii 1.0\n" + before + "element vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\n" + faceElement + "end_header\n";
}

const std::string plyPoints = "0 0 0\n0.2 0 0\n0 0.3 0\n0 0 0.4\n";
const std::string plyFaces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const std::string faceElement = "element face 4\nproperty list uchar int vertex_indices\n";
} // namespace

TEST_CASE("Comments, blanks and continued lines of an .obj file", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::vector<std::string> contents = {
      "\xEF\xBB\xBF" + points + faces,
      points + "# a path C:\\\n" + faces,
      points + "f 1 3 2 # bottom\n" + faces.substr(8),
      "  v 0 0 0\n\tv 0.2 0 0\n v 0 0.3 0 # up\n v 0 0 0.4\n  f 1 3 2\n  f 1 2 4\n  f 2 3 4\n  f 3 1 4\n",
      points + "f 1 \\\n3 2\nf -4 -3 -1\nf 2// 3// 4//\nf 3 1 4\n",
      points + "o box#1\ng a b\ns off\n" + faces,
      "v 0 0 0 1\nv +0.2 0 0 1\nv 0 3e-1 0 1\nv 0 0 .4 1\nvn 0 0 1\nf 1//1 3//1 2//1\n" + faces.substr(8)};
  for (const std::string &content : contents) {
    CAPTURE(content);
    requireTetrahedron(vpModelReader::read(folder.write("forms.obj", content)));
  }
}

TEST_CASE("Lines of an .obj file that are wrong are told by their number", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  for (const auto &[bad, told] : {std::pair<std::string, std::string>{"f 1 2 9", "index 9"},
                                  {"f 0 1 2", "index 0"},
                                  {"f 1 2", "three corners"},
                                  {"f 1/1 2/1 3/1", "texture coordinate"},
                                  {"v 0,5 0 0", "decimal comma"},
                                  {"v 1 2", "2 numbers"},
                                  {"v 1 2 x", "'x'"},
                                  {"v 0 0 0 256 0 0", "colour"}}) {
    CAPTURE(bad);
    CHECK_THAT(messageOfFile(folder.write("wrong.obj", points + bad + "\n" + faces)),
               ContainsSubstring("wrong.obj', line 5") && ContainsSubstring(told));
  }
}

TEST_CASE("Material files: attributes that are not known, several of them, missing ones", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("pbr.mtl", "newmtl blue\nKd 0 0 1\naniso 0\nanisor 0\nPr 0.5\nmap_Pr x.png\n");
  vpTrackedModel model =
      vpModelReader::read(folder.write("pbr.obj", "mtllib pbr.mtl\n" + points + "usemtl blue\n" + faces));
  REQUIRE(model.appearance().color.size() == 4);
  CHECK(model.appearance().color[3][1] == Eigen::Vector3f(0.F, 0.F, 1.F));

  folder.write("one.mtl", "newmtl red\nKd 1 0 0\n");
  model =
      vpModelReader::read(folder.write("two.obj", "mtllib one.mtl pbr.mtl\n" + points +
                                                      "usemtl red\nf 1 3 2\nf 1 2 4\nusemtl blue\nf 2 3 4\nf 3 1 4\n"));
  REQUIRE(model.appearance().color.size() == 4);
  CHECK(model.appearance().color[1][0] == Eigen::Vector3f(1.F, 0.F, 0.F));
  CHECK(model.appearance().color[2][0] == Eigen::Vector3f(0.F, 0.F, 1.F));

  folder.write("my skin.mtl", "newmtl red\nKd 1 0 0\n");
  model = vpModelReader::read(folder.write("blank.obj", "mtllib my skin.mtl\n" + points + "usemtl red\n" + faces));
  CHECK(model.appearance().color.size() == 4);
  CHECK(model.report().warnings.empty());

  model = vpModelReader::read(folder.write("lost.obj", "mtllib lost.mtl\n" + points + "usemtl red\n" + faces));
  CHECK(model.appearance().color.empty());
  REQUIRE(model.report().warnings.size() == 1);
  CHECK_THAT(model.report().warnings[0], ContainsSubstring("lost.mtl"));
  model = vpModelReader::read(folder.write("other.obj", "mtllib one.mtl\n" + points + "usemtl green\n" + faces));
  REQUIRE(model.report().warnings.size() == 1);
  CHECK_THAT(model.report().warnings[0], ContainsSubstring("green"));
}

TEST_CASE("Colours of vertices that go to 255 are brought to 1", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string color = " 255 128 0\n";
  const vpTrackedModel model = vpModelReader::read(folder.write(
      "bytes.obj", "v 0 0 0" + color + "v 0.2 0 0" + color + "v 0 0.3 0" + color + "v 0 0 0.4" + color + faces));
  REQUIRE(model.appearance().color.size() == 4);
  CHECK((model.appearance().color[0][0] - Eigen::Vector3f(1.F, 0.502F, 0.F)).norm() < 1e-3F);
}

TEST_CASE("Coordinates far from the origin keep their digits where the file has them", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string far = "v 500000.1 0 0\nv 500000.3 0 0\nv 500000.1 0.3 0\nv 500000.1 0 0.4\n";
  requireTetrahedron(vpModelReader::read(folder.write("far.obj", far + faces)));
}

TEST_CASE("Strips of triangles in a .ply file", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  // Around the tetrahedron, and in pieces.
  for (const std::string strip :
       {"6 0 2 1 3 0 2\n", "12 0 2 1 3 -1 3 0 1 -1 2 0 3\n", "13 0 2 1 3 -1 1 0 3 -1 -1 3 0 2\n"}) {
    CAPTURE(strip);
    requireTetrahedron(vpModelReader::read(folder.write("strip.ply", plyHeader("4", strips) + plyPoints + strip)));
  }
}

TEST_CASE("Headers of .ply files: blanks, other elements, names of types", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  std::string blank = plyHeader("4", faceElement);
  blank.insert(blank.size() - 1, " ");
  requireTetrahedron(vpModelReader::read(folder.write("blank.ply", blank + plyPoints + plyFaces)));
  const std::string camera = "element camera 1\nproperty float view_px\nproperty list uchar float axis\n";
  requireTetrahedron(vpModelReader::read(
      folder.write("camera.ply", plyHeader("4", faceElement, camera) + "0.5 3 1 0 0\n" + plyPoints + plyFaces)));
  requireTetrahedron(vpModelReader::read(
      folder.write("edges.ply", plyHeader("4", faceElement + "element edge 1\nproperty int32 a\nproperty int32 b\n") +
                                    plyPoints + plyFaces + "0 1\n")));
  const std::string quality = "element face 4\nproperty float64 quality\nproperty list uint8 uint32 vertex_index\n";
  requireTetrahedron(vpModelReader::read(folder.write(
      "quality.ply", plyHeader("4", quality) + plyPoints + "0.5 3 0 2 1\n0.5 3 0 1 3\n0.5 3 1 2 3\n0.5 3 2 0 3\n")));
}

TEST_CASE("A binary .ply file whose data start like the end of a line", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  for (const std::string end : {"\n", "\r\n"}) {
    std::string content = "ply\nformat binary_little_endian 1.0\nelement tag 1\nproperty uchar a\nelement vertex 4\n"
                          "property double x\nproperty double y\nproperty double z\n" +
                          faceElement + "end_header\n";
    for (std::size_t at = 0; end != "\n" && (at = content.find('\n', at)) != std::string::npos; at += end.size()) {
      content.replace(at, 1, end);
    }
    content += '\n'; // The tag.
    for (const double coordinate : {0., 0., 0., 0.2, 0., 0., 0., 0.3, 0., 0., 0., 0.4}) {
      meshFiles::append(content, coordinate);
    }
    for (const std::array<int, 3> &face : {std::array<int, 3>{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}) {
      content += '\3';
      for (const int index : face) {
        meshFiles::append(content, static_cast<std::int32_t>(index));
      }
    }
    requireTetrahedron(vpModelReader::read(folder.write("newline.ply", content)));
  }
}

TEST_CASE("Counts of a .ply file that its data do not have are told", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string body = plyPoints + plyFaces;
  CHECK_THAT(messageOfFile(folder.write("less.ply", plyHeader("4", faceElement) + plyPoints + plyFaces.substr(0, 16))),
             ContainsSubstring("less.ply") && ContainsSubstring("cut off"));
  CHECK_THAT(messageOfFile(folder.write("more.ply", plyHeader("4", faceElement) + body + "3 0 1 2\n")),
             ContainsSubstring("more.ply") && ContainsSubstring("too small"));
  CHECK_THAT(messageOfFile(folder.write("huge.ply", plyHeader("90000000", faceElement) + body)),
             ContainsSubstring("huge.ply") && ContainsSubstring("90000000"));
  CHECK_THAT(messageOfFile(folder.write("index.ply", plyHeader("3", faceElement) + plyPoints.substr(0, 22) + plyFaces)),
             ContainsSubstring("index.ply") && ContainsSubstring("index 3"));
}

TEST_CASE("Binary .stl files that start with solid, have colours, or text after them; several solids in a text",
          "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const modelShapes::Point o(0., 0., 0.), x(0.2, 0., 0.), y(0., 0.3, 0.), z(0., 0., 0.4);
  const meshFiles::Triangles shape = {{{o, y, x}}, {{o, x, z}}, {{x, y, z}}, {{y, o, z}}};
  std::string binary = meshFiles::binaryStl(shape);
  binary.replace(0, 5, "solid");
  requireTetrahedron(vpModelReader::read(folder.write("solid.stl", binary)));
  const vpTrackedModel longer = vpModelReader::read(folder.write("longer.stl", binary + std::string(8, '\0')));
  requireTetrahedron(longer);
  CHECK(longer.report().warnings.size() == 1);
  binary[binary.size() - 1] = '\xFC'; // A colour, 0x1F << 10 with the bit that says so.
  const vpTrackedModel red = vpModelReader::read(folder.write("red.stl", binary));
  REQUIRE(red.appearance().color.size() == 4);
  CHECK(red.appearance().color[3][0] == Eigen::Vector3f(1.F, 0.F, 0.F));
  std::string text = meshFiles::asciiStl({shape[0], shape[1]}) + "\n" + meshFiles::asciiStl({shape[2], shape[3]});
  requireTetrahedron(vpModelReader::read(folder.write("two.stl", text)));
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  requireTetrahedron(vpModelReader::read(folder.write("upper.stl", "  " + text)));
}

TEST_CASE("Binary .stl files whose header does not tell the number of triangles", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const modelShapes::Point o(0., 0., 0.), x(0.2, 0., 0.), y(0., 0.3, 0.), z(0., 0., 0.4);
  const std::string binary = meshFiles::binaryStl({{{o, y, x}}, {{o, x, z}}, {{x, y, z}}, {{y, o, z}}});
  for (const std::string &count : {std::string(4, '\0'), std::string(4, '\xFF')}) {
    std::string streamed = binary;
    const vpTrackedModel model = vpModelReader::read(folder.write("streamed.stl", streamed.replace(80, 4, count)));
    requireTetrahedron(model);
    CHECK(model.report().warnings.size() == 1);
    CHECK_THAT(messageOfFile(folder.write("cut.stl", streamed.substr(0, 200))), ContainsSubstring("cut.stl"));
  }
}

TEST_CASE("Faces of an .obj file may stand before their vertices, and lines without a keyword are told", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  requireTetrahedron(vpModelReader::read(folder.write("before.obj", faces + points)));
  CHECK_THAT(messageOfFile(folder.write("beyond.obj", faces + points + "f 1 2 5\n")),
             ContainsSubstring("beyond.obj', line 9") && ContainsSubstring("index 5"));
  CHECK_THAT(messageOfFile(folder.write("back.obj", points + "f -1 -2 -5\n")),
             ContainsSubstring("back.obj', line 5") && ContainsSubstring("index -5"));
  const vpTrackedModel model = vpModelReader::read(folder.write("more.obj", points + "vc 1 0 0\nvc 0 0 1\n" + faces));
  requireTetrahedron(model);
  REQUIRE(model.report().warnings.size() == 1);
  CHECK_THAT(model.report().warnings[0], ContainsSubstring("2 lines") && ContainsSubstring("line 5, 'vc'"));
  const std::string weights = "v 0 0 0 1\nv 0.2 0 0 0.5\nv 0 0.3 0\nv 0 0 0.4\n";
  const vpTrackedModel weighted = vpModelReader::read(folder.write("weights.obj", weights + faces));
  requireTetrahedron(weighted);
  REQUIRE(weighted.report().warnings.size() == 1);
  CHECK_THAT(weighted.report().warnings[0], ContainsSubstring("weight"));
}

TEST_CASE("Polygons that cross themselves, and a warning for each line, do not take the square of the time", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const auto seconds = [](const auto &run) {
    const double start = processorTime();
    run();
    return processorTime() - start;
  };
  constexpr int polygons = 100, corners = 1000;
  std::ostringstream crossing;
  unsigned int state = 1;
  const auto draw = [&state] { return 0.1 + 0.1 * (state = state * 1664525U + 1013904223U) / 4294967296.; };
  for (int i = 0; i < polygons * corners; ++i) {
    const double angle = 2. * M_PI * i / corners;
    crossing << "v " << draw() * std::cos(angle) << " " << draw() * std::sin(angle) << " " << 0.001 * (i / corners)
             << "\n";
  }
  for (int i = 0; i < polygons; ++i) {
    crossing << "f";
    for (int k = 1; k <= corners; ++k) {
      crossing << " " << i * corners + k;
    }
    crossing << "\n";
  }
  // It takes a tenth of that, and took 7 s.
  CHECK(seconds([&] { vpModelReader::read(folder.write("crossing.obj", crossing.str())); }) < 5.);

  std::string lost = points;
  for (int i = 0; i < 100000; ++i) {
    lost += "usemtl m" + std::to_string(i) + "\n" + "f 1 3 2\n";
  }
  folder.write("skin.mtl", "newmtl other\n");
  // A fiftieth of that, and it took half a minute.
  CHECK(seconds([&] {
          const vpTrackedModel model =
              vpModelReader::read(folder.write("lost.obj", "mtllib skin.mtl\n" + lost + faces));
          CHECK(model.report().warnings.size() == 101);
          CHECK_THAT(model.report().warnings.back(), ContainsSubstring("more warnings"));
        }) < 5.);
}
