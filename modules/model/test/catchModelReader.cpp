// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "meshFiles.h"

#include <visp3/core/vpException.h>
#include <visp3/model/vpModelReader.h>

namespace {
using meshFiles::Triangles;
using modelShapes::Point;

const Point boxSize(0.1, 0.2, 0.3);
const Point boxCentre(0.05, 0., 0.15);

Triangles box(double unit)
{
  return modelShapes::boxTriangles(boxSize / unit, 1, boxCentre / unit);
}

vpModelOptions inUnit(double unit)
{
  vpModelOptions options;
  options.unit = unit;
  return options;
}

void checkBox(const vpTrackedModel &model)
{
  CHECK(model.vertices().size() == 8);
  CHECK(model.triangles().size() == 12);
  CHECK(model.edges().size() == 12);
  CHECK(model.faces().size() == 6);
  CHECK(model.isConvex());
  CHECK(model.report().flippedTriangles == 0);
  CHECK((model.report().size - boxSize).norm() < 1e-6);
  CHECK((model.report().centreOffset - boxCentre).norm() < 1e-6);
}

std::string messageOf(const std::string &file)
{
  try {
    vpModelReader::read(file);
  } catch (const vpException &e) {
    return e.what();
  }
  return "";
}

void checkColor(const vpRGBa &pixel, int red, int green, int blue)
{
  CHECK(static_cast<int>(pixel.R) == red);
  CHECK(static_cast<int>(pixel.G) == green);
  CHECK(static_cast<int>(pixel.B) == blue);
}

//! A PPM image of 2 x 1 pixels, red and blue.
std::string redAndBlue()
{
  return std::string("P6\n2 1\n255\n\xff\0\0\0\0\xff", 17);
}
} // namespace

TEST_CASE("Meshes are known by the extension of their file")
{
  for (const char *name : {"a.obj", "a.PLY", "b/c.Stl", "d.dae", "e.gltf", "f.1.glb"}) {
    CHECK(vpModelReader::isMesh(name));
  }
  for (const char *name : {"a.cao", "a.wrl", "obj", "", "a.obj.txt", "a.obj/b"}) {
    CHECK_FALSE(vpModelReader::isMesh(name));
  }
}

TEST_CASE("One box in all formats and units")
{
  const meshFiles::TemporaryFolder folder;
  for (const double unit : {1., 0.01, 0.001}) {
    CAPTURE(unit);
    const Triangles triangles = box(unit);
    checkBox(vpModelReader::read(folder.write("box.obj", meshFiles::obj(triangles)), inUnit(unit)));
    checkBox(vpModelReader::read(folder.write("box.ply", meshFiles::ply(triangles)), inUnit(unit)));
    checkBox(vpModelReader::read(folder.write("box.stl", meshFiles::asciiStl(triangles)), inUnit(unit)));
    checkBox(vpModelReader::read(folder.write("box.STL", meshFiles::binaryStl(triangles)), inUnit(unit)));
    checkBox(vpModelReader::read(folder.write("box.dae", meshFiles::dae(triangles, "")), inUnit(unit)));
    checkBox(vpModelReader::read(folder.write("box.glb", meshFiles::glb(triangles)), inUnit(unit)));
    folder.write("box.bin", meshFiles::floats(triangles));
    const std::string gltf = meshFiles::gltfJson(triangles, "\"uri\":\"box.bin\",");
    checkBox(vpModelReader::read(folder.write("box.gltf", gltf), inUnit(unit)));
  }
}

TEST_CASE("A .dae file's own unit counts, its up axis does not")
{
  const meshFiles::TemporaryFolder folder;
  const std::string millimetres = "<unit name=\"millimeter\" meter=\"0.001\"/>";
  checkBox(vpModelReader::read(folder.write("mm.dae", meshFiles::dae(box(0.001), millimetres))));
  for (const std::string axis : {"X_UP", "Y_UP", "Z_UP"}) {
    const std::string up = "<up_axis>" + axis + "</up_axis>";
    checkBox(vpModelReader::read(folder.write("up.dae", meshFiles::dae(box(1.), up))));
  }
}

TEST_CASE("Nodes are transformed, mirrored ones too")
{
  const meshFiles::TemporaryFolder folder;
  const std::string moved = "<translate>0 0 1</translate><scale>-1 1 1</scale>";
  const vpTrackedModel model = vpModelReader::read(folder.write("moved.dae", meshFiles::dae(box(1.), "", moved)));
  CHECK((model.report().centreOffset - Point(-0.05, 0., 1.15)).norm() < 1e-6);
  CHECK(model.report().flippedTriangles == 0);
}

TEST_CASE("A pose of the mesh in the object frame")
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.write("box.obj", meshFiles::obj(box(0.001)));
  const vpHomogeneousMatrix oMm(1., 2., 3., 0., 0., M_PI / 2.);
  const vpTrackedModel model = vpModelReader::read(file, inUnit(0.001), oMm);
  CHECK((model.report().centreOffset - Point(1., 2.05, 3.15)).norm() < 1e-6);
  CHECK((model.report().size - Point(0.2, 0.1, 0.3)).norm() < 1e-6);
}

TEST_CASE("Polygons of a mesh are cut into triangles, its lines and points are left out")
{
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nl 1 3\np 2\n");
  const vpTrackedModel model = vpModelReader::read(file);
  CHECK(model.triangles().size() == 2);
  CHECK(model.edges().size() == 4);
}

TEST_CASE("Colours of vertices and materials")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("red.mtl", "newmtl red\nKd 1 0.5 0\n");
  const std::string file = folder.write("red.obj", "mtllib red.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl red\nf 1 2 3\n");
  const vpTrackedModel model = vpModelReader::read(file);
  REQUIRE(model.appearance().color.size() == 1);
  CHECK((model.appearance().color[0][2] - Eigen::Vector3f(1.F, 0.5F, 0.F)).norm() < 1e-6F);
  CHECK(model.appearance().image.empty());
  const std::string plain = folder.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  CHECK(vpModelReader::read(plain).appearance().color.empty());
  const std::string painted = folder.write("painted.ply", meshFiles::coloredPlyHeader(3, 1) +
                                                              "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n3 0 1 2\n");
  const vpTrackedModel rainbow = vpModelReader::read(painted);
  REQUIRE(rainbow.appearance().color.size() == 1);
  CHECK((rainbow.appearance().color[0][1] - Eigen::Vector3f(0.F, 1.F, 0.F)).norm() < 1e-6F);
}

TEST_CASE("Texture images are found beside the model, missing ones are counted")
{
  const meshFiles::TemporaryFolder folder;
  const std::string content = "mtllib skin.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1.25 0.75\n"
                              "usemtl skin\nf 1/1 2/2 3/3\n";
  const std::string file = folder.write("skin.obj", content);
  folder.write("skin.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd C:\\textures\\skin.ppm\n");
  const vpTrackedModel bare = vpModelReader::read(file);
  CHECK(bare.report().missingImages == 1);
  CHECK(bare.appearance().images.empty());

  folder.write("skin.ppm", redAndBlue());
  const vpTrackedModel model = vpModelReader::read(file);
  if (model.report().missingImages > 0) {
    WARN("built without OpenCV: texture images are not read");
    return;
  }
  REQUIRE(model.appearance().images.size() == 1);
  CHECK(model.appearance().image == std::vector<int>(1, 0));
  CHECK(model.appearance().images[0].getWidth() == 2);
  checkColor(model.appearance().images[0][0][0], 255, 0, 0);
  CHECK((model.appearance().texture[0][0] - Eigen::Vector2f(0.F, 1.F)).norm() < 1e-6F);
  CHECK((model.appearance().texture[0][2] - Eigen::Vector2f(1.25F, 0.25F)).norm() < 1e-6F);
}

TEST_CASE("A texture inside the file")
{
  const meshFiles::TemporaryFolder folder;
  // A PNG image of one green pixel.
  const std::string image = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNg"
                            "+M8AAAICAQB7CYF4AAAAAElFTkSuQmCC";
  std::string data = meshFiles::floats({{{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0)}}});
  for (const float uv : {0.F, 0.F, 1.F, 0.F, 1.F, 0.75F}) {
    meshFiles::append(data, uv);
  }
  folder.write("skin.bin", data);
  const std::string file = folder.write(
      "skin.gltf",
      "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":["
      "{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"material\":0}]}],\"materials\":[{"
      "\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],\"textures\":[{\"source\":0}],\"images\":[{"
      "\"uri\":\"" +
          image +
          "\"}],\"buffers\":[{\"uri\":\"skin.bin\",\"byteLength\":60}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":"
          "36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":24}],\"accessors\":[{\"bufferView\":0,"
          "\"componentType\":5126,\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,0]},{\"bufferView\":1,"
          "\"componentType\":5126,\"count\":3,\"type\":\"VEC2\"}]}");
  const vpTrackedModel model = vpModelReader::read(file);
  if (model.report().missingImages > 0) {
    WARN("built without OpenCV: texture images are not read");
    return;
  }
  REQUIRE(model.appearance().images.size() == 1);
  checkColor(model.appearance().images[0][0][0], 0, 255, 0);
  // v runs down in a .gltf file, as in our images.
  CHECK((model.appearance().texture[0][2] - Eigen::Vector2f(1.F, 0.75F)).norm() < 1e-6F);
}

TEST_CASE("Files that are no good are named")
{
  const meshFiles::TemporaryFolder folder;
  CHECK_THAT(messageOf(folder.path("none.obj")), ContainsSubstring("none.obj' does not exist"));
  CHECK_THAT(messageOf(folder.write("void.obj", "")), ContainsSubstring("void.obj' is empty"));
  CHECK_THAT(messageOf(folder.write("box.cao", "V1\n")), ContainsSubstring("box.cao") && ContainsSubstring(".ply"));
  std::filesystem::create_directory(folder.path("folder.obj"));
  CHECK_THAT(messageOf(folder.path("folder.obj")), ContainsSubstring("is not a file"));
  for (const std::string extension : {"obj", "ply", "stl", "dae", "gltf", "glb"}) {
    const std::string name = "noise." + extension;
    CHECK_THAT(messageOf(folder.write(name, "\x01\x02 what is this? \xff\xfe { < ")), ContainsSubstring(name));
  }
  CHECK_THAT(messageOf(folder.write("cut.ply", meshFiles::ply(box(1.)).substr(0, 60))), ContainsSubstring("cut.ply"));
  const std::string cut = meshFiles::binaryStl(box(1.)).substr(0, 200);
  CHECK_THAT(messageOf(folder.write("cut.stl", cut)), ContainsSubstring("cut.stl"));
}

TEST_CASE("Meshes that are no good are named")
{
  const meshFiles::TemporaryFolder folder;
  const std::string cloud = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                            "property float z\nend_header\n0 0 0\n1 0 0\n1 1 0\n";
  CHECK_THAT(messageOf(folder.write("cloud.ply", cloud)), ContainsSubstring("cloud.ply' has no triangles"));
  CHECK_THAT(messageOf(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\np 1 2 3\n")),
             ContainsSubstring("points.obj"));
  CHECK_THAT(messageOf(folder.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 1 1 0\nf 1 2 3\n")),
             ContainsSubstring("nan.obj") && ContainsSubstring("finite"));
  CHECK_THAT(messageOf(folder.write("range.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                                 "property float y\nproperty float z\nelement face 1\n"
                                                 "property list uchar int vertex_indices\nend_header\n"
                                                 "0 0 0\n1 0 0\n1 1 0\n4 0 1 2 999\n")),
             ContainsSubstring("range.ply"));
  CHECK_THAT(messageOf(folder.write("box.obj", meshFiles::obj(box(0.001)))),
             ContainsSubstring("box.obj' is 374.2 m wide (unit 1 m)") && ContainsSubstring("0.001"));
}
