// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "fileVariants.h"
#include "meshFiles.h"

#include <visp3/model/vpModelReader.h>

// Scenes (.dae, .gltf, .glb) that would make assimp recurse, make something up, or leave something out.

namespace {
const std::string daeStart = "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
                             "version=\"1.4.1\"><asset/>";
const std::string daeEnd = "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";

meshFiles::Triangles box()
{
  return modelShapes::boxTriangles(modelShapes::Point(0.2, 0.3, 0.4));
}

std::string geometry()
{
  const std::string dae = meshFiles::dae(box(), "");
  const std::size_t start = dae.find("<library_geometries>");
  return dae.substr(start, dae.find("<library_visual_scenes>") - start);
}

std::string visualScene(const std::string &nodes)
{
  return "<library_visual_scenes><visual_scene id=\"s\">" + nodes + "</visual_scene></library_visual_scenes>";
}

std::string messageOfFile(const std::string &file)
{
  return messageOf([&file] { vpModelReader::read(file); });
}

std::string replaced(std::string text, const std::string &from, const std::string &to)
{
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

std::string gltf(const std::string &extra, const std::string &uri = "box.bin")
{
  return replaced(meshFiles::gltfJson(box(), "\"uri\":\"" + uri + "\","), "{\"asset\"", "{" + extra + "\"asset\"");
}
} // namespace

TEST_CASE("A .dae file of nodes alone has no triangles", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string rig =
      "<node id=\"rig\"><node id=\"a\"><translate>0.1 0 0</translate><node id=\"b\"><translate>0 0.2 "
      "0</translate></node></node></node>";
  CHECK_THAT(messageOfFile(folder.write("rig.dae", daeStart + visualScene(rig) + daeEnd)),
             ContainsSubstring("rig.dae' has no triangles"));
  const std::string typo =
      replaced(rig, "</translate></node>", "</translate><instance_geometry url=\"#typo\"/></node>");
  CHECK_THAT(messageOfFile(folder.write("typo.dae", daeStart + geometry() + visualScene(typo) + daeEnd)),
             ContainsSubstring("typo.dae' has no triangles") && ContainsSubstring("#typo"));
}

TEST_CASE("A .dae file with a part that is missing, or with unit 0", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string good = meshFiles::dae(box(), "<unit meter=\"1\"/>");
  CHECK_THAT(messageOfFile(folder.write("unit.dae", replaced(good, "meter=\"1\"", "meter=\"0\""))),
             ContainsSubstring("unit.dae") && ContainsSubstring("unit 0"));
  CHECK_THAT(messageOfFile(folder.write("lost.dae", replaced(good, "url=\"#g\"", "url=\"#gg\""))),
             ContainsSubstring("lost.dae") && ContainsSubstring("no triangles") && ContainsSubstring("#gg"));
  CHECK_THAT(messageOfFile(folder.write("two.dae", replaced(good, "<instance_geometry url=\"#g\"/>",
                                                            "<instance_geometry url=\"#g\"/><instance_geometry "
                                                            "url=\"#h\"/>"))),
             ContainsSubstring("two.dae") && ContainsSubstring("#h"));
  CHECK_THAT(
      messageOfFile(folder.write("count.dae", replaced(good, "<triangles count=\"12\"", "<triangles count=\"14\""))),
      ContainsSubstring("count.dae") && ContainsSubstring("14"));
}

TEST_CASE("Nodes that contain themselves, are nested deeply, or multiply, are refused", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string self = "<library_nodes><node id=\"a\"><instance_node url=\"#a\"/><instance_geometry url=\"#g\"/>"
                           "</node></library_nodes>";
  const std::string use = visualScene("<node id=\"n\"><instance_node url=\"#a\"/></node>");
  CHECK_THAT(messageOfFile(folder.write("self.dae", daeStart + geometry() + self + use + daeEnd)),
             ContainsSubstring("self.dae") && ContainsSubstring("itself"));
  std::string deep;
  for (int i = 0; i < 20000; ++i) {
    deep += "<node>";
  }
  deep += "<instance_geometry url=\"#g\"/>";
  for (int i = 0; i < 20000; ++i) {
    deep += "</node>";
  }
  CHECK_THAT(messageOfFile(folder.write("deep.dae", daeStart + geometry() + visualScene(deep) + daeEnd)),
             ContainsSubstring("deep.dae") && ContainsSubstring("nested"));
  std::string many = "<library_nodes><node id=\"a0\"><instance_geometry url=\"#g\"/></node>";
  for (int i = 1; i <= 40; ++i) {
    const std::string one = "<instance_node url=\"#a" + std::to_string(i - 1) + "\"/>";
    many += "<node id=\"a" + std::to_string(i) + "\">" + one + one + "</node>";
  }
  many += "</library_nodes>" + visualScene("<node><instance_node url=\"#a40\"/></node>");
  CHECK_THAT(messageOfFile(folder.write("many.dae", daeStart + geometry() + many + daeEnd)),
             ContainsSubstring("many.dae"));

  // A small file of many copies is refused before it fills the memory.
  const fileVariants::MemoryLimit limit(std::size_t(1) << 30U);
  const std::string ball = meshFiles::dae(modelShapes::sphereTriangles(0.1, 40, 40), "");
  std::string copies;
  for (int i = 0; i < 2000; ++i) {
    copies += "<instance_geometry url=\"#g\"/>";
  }
  CHECK_THAT(messageOfFile(folder.write("copies.dae", replaced(ball, "<instance_geometry url=\"#g\"/>", copies))),
             ContainsSubstring("copies.dae") && ContainsSubstring("more than 3000000"));

  CHECK_THAT(
      messageOfFile(folder.write("self.gltf", replaced(gltf(""), "{\"mesh\":0", "{\"children\":[0],\"mesh\":0"))),
      ContainsSubstring("self.gltf") && ContainsSubstring("itself"));
  CHECK_THAT(messageOfFile(folder.write("json.gltf", std::string(200000, '['))), ContainsSubstring("json.gltf"));
  CHECK_THAT(messageOfFile(folder.write("twice.gltf", gltf("\"meshes\":[],"))),
             ContainsSubstring("twice.gltf") && ContainsSubstring("'meshes' is there twice"));
}

TEST_CASE("Names of a .gltf file's buffers and images may be percent-encoded", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("my box.bin", meshFiles::floats(box()));
  const vpTrackedModel model = vpModelReader::read(folder.write("space.gltf", gltf("", "my%20box.bin")));
  CHECK(model.triangles().size() == 12);
  CHECK(model.appearance().color.empty()); // The file tells of no material.
  folder.write("100%25.bin", meshFiles::floats(box()));
  CHECK(vpModelReader::read(folder.write("sign.gltf", gltf("", "100%25.bin"))).triangles().size() == 12);
}

TEST_CASE("A .gltf file's material colours its mesh, and names of images may be percent-encoded", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("box.bin", meshFiles::floats(box()));
  const std::string red = gltf("\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,1]}}],");
  const vpTrackedModel model =
      vpModelReader::read(folder.write("red.gltf", replaced(red, "{\"attributes\"", "{\"material\":0,\"attributes\"")));
  REQUIRE(model.appearance().color.size() == 12);
  CHECK(model.appearance().color[0][0] == Eigen::Vector3f(1.F, 0.F, 0.F));
  // Positions serve as texture coordinates; an image that is no file, and then one that is.
  std::string textured = gltf("\"images\":[{\"uri\":\"my%20skin.ppm\"}],\"textures\":[{\"source\":0}],\"materials\":[{"
                              "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],");
  textured = replaced(textured, "{\"attributes\":{", "{\"material\":0,\"attributes\":{\"TEXCOORD_0\":1,");
  textured =
      replaced(textured, "\"accessors\":[",
               "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":36,\"type\":\"VEC3\",\"min\":[-100,"
               "-100,-100],\"max\":[100,100,100]},{\"bufferView\":0,\"componentType\":5126,\"count\":36,\"type\":"
               "\"VEC2\"}],\"unused\":[");
  CHECK(vpModelReader::read(folder.write("textured.gltf", textured)).report().missingImages == 1);
  folder.write("my skin.ppm", std::string("P6 1 1 255\n\xFF\x80\x01", 14));
  const vpTrackedModel skinned = vpModelReader::read(folder.write("textured.gltf", textured));
  CHECK(skinned.report().missingImages == 0);
  REQUIRE(skinned.appearance().images.size() == 1);
}

TEST_CASE("Extensions that a .gltf file requires have to be known", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("box.bin", meshFiles::floats(box()));
  for (const std::string name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_mesh_quantization"}) {
    CHECK_THAT(messageOfFile(folder.write("needs.gltf", gltf("\"extensionsRequired\":[\"" + name + "\"],"))),
               ContainsSubstring("needs.gltf") && ContainsSubstring(name));
  }
  const std::string look = "\"extensionsRequired\":[\"KHR_materials_unlit\"],";
  CHECK(vpModelReader::read(folder.write("look.gltf", gltf(look))).triangles().size() == 12);
}

TEST_CASE("Transformations of a .gltf file's nodes need all of their numbers", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("box.bin", meshFiles::floats(box()));
  const auto moved = [&](const std::string &transformation) {
    return folder.write("moved.gltf", replaced(gltf(""), "{\"mesh\":0", "{" + transformation + ",\"mesh\":0"));
  };
  const modelShapes::Point centre = vpModelReader::read(moved("\"translation\":[0,0,1]")).report().centreOffset;
  const vpTrackedModel turned = vpModelReader::read(moved("\"rotation\":[0,0,1,0],\"translation\":[0,0,1]"));
  CHECK((turned.report().centreOffset - modelShapes::Point(-centre.x(), -centre.y(), centre.z())).norm() < 1e-6);
  for (const std::string broken : {"\"translation\":[0,1]", "\"translation\":\"x\"", "\"matrix\":[1,0,0,0]",
                                   "\"rotation\":[0,0,0,0]", "\"rotation\":[2,0,0,0]", "\"scale\":[1,1,\"1\"]"}) {
    CAPTURE(broken);
    CHECK_THAT(messageOfFile(moved(broken)),
               ContainsSubstring("moved.gltf") && ContainsSubstring("numbers are needed"));
  }
}

TEST_CASE("What a .gltf file says of a skeleton is told to be left out", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("box.bin", meshFiles::floats(box()));
  const std::string skinned = replaced(gltf("\"skins\":[{\"joints\":[0]}],"), "{\"mesh\":0", "{\"skin\":0,\"mesh\":0");
  const vpTrackedModel model = vpModelReader::read(folder.write("skin.gltf", skinned));
  REQUIRE(model.report().warnings.size() == 1);
  CHECK_THAT(model.report().warnings[0], ContainsSubstring("skeleton"));
}

TEST_CASE("Accessors of a .gltf file have to be in their buffers", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("box.bin", meshFiles::floats(box()));
  for (const std::string count : {"37", "39", "4294967295", "-3", "1e9"}) {
    CAPTURE(count);
    CHECK_THAT(messageOfFile(folder.write("count.gltf", replaced(gltf(""), "\"count\":36", "\"count\":" + count))),
               ContainsSubstring("count.gltf"));
  }
  folder.write("box.bin", meshFiles::floats(box()).substr(0, 200));
  CHECK_THAT(messageOfFile(folder.write("cut.gltf", gltf(""))), ContainsSubstring("cut.gltf"));
}

TEST_CASE("A .gltf file that is refused leaves no file open", "[files]")
{
  const std::filesystem::path openFiles = "/proc/self/fd";
  if (!std::filesystem::exists(openFiles)) {
    WARN("Left out: there is no /proc/self/fd");
    return;
  }
  const auto countOpen = [&] { return std::distance(std::filesystem::directory_iterator(openFiles), {}); };
  const meshFiles::TemporaryFolder folder;
  folder.write("box.bin", meshFiles::floats(box()).substr(0, 200));
  const std::string file = folder.write("cut.gltf", gltf(""));
  const auto before = countOpen();
  for (int i = 0; i < 10; ++i) {
    CHECK_THAT(messageOfFile(file), ContainsSubstring("cut.gltf"));
  }
  CHECK(countOpen() == before);
}

TEST_CASE(
    "A scene far from its origin keeps its digits where the file has them; else the report warns, or it is refused",
    "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const auto at = [](double x) {
    return modelShapes::boxTriangles(modelShapes::Point(0.2, 0.3, 0.4), 1, modelShapes::Point(x, 0., 0.));
  };
  std::string text = meshFiles::dae(at(0.), "", "<translate>900000.125 0 0</translate>");
  const vpTrackedModel exact = vpModelReader::read(folder.write("far.dae", text));
  CHECK((exact.report().size - modelShapes::Point(0.2, 0.3, 0.4)).norm() < 1e-9);
  CHECK(exact.report().warnings.empty());
  // 32-bit floats, as the format has it.
  const auto floats = [&](double x) {
    folder.write("box.bin", meshFiles::floats(at(x)));
    return folder.write("far.gltf", gltf(""));
  };
  CHECK(vpModelReader::read(floats(10.)).report().warnings.empty());
  CHECK(vpModelReader::read(floats(2000.)).report().warnings.size() == 1);
  CHECK_THAT(messageOfFile(floats(900000.)), ContainsSubstring("far.gltf") && ContainsSubstring("origin"));
}
