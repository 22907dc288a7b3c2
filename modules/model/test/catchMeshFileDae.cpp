// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>
#include <exceptionMessage.h>

#include "meshFiles.h"

#include <visp3/model/vpModelReader.h>

// What COLLADA (.dae) has beside triangles in a node: other polygons, transformations, colours and images.

namespace {
meshFiles::Triangles box()
{
  return modelShapes::boxTriangles(modelShapes::Point(0.2, 0.3, 0.4));
}

// \param polygons With the letter I for the input.
std::string tetrahedronDae(const std::string &input, std::string polygons)
{
  for (std::size_t at = 0; (at = polygons.find('I', at)) != std::string::npos; at += input.size()) {
    polygons.replace(at, 1, input);
  }
  return "<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\"><asset/>"
         "<library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"12\">0 0 0 0.2 0 "
         "0 "
         "<!-- here --> 0 0.3 0 0 0 0.4</float_array><technique_common><accessor source=\"#a\" count=\"4\" "
         "stride=\"3\">"
         "<param name=\"X\"/><param name=\"Y\"/><param name=\"Z\"/></accessor></technique_common></source><vertices "
         "id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>" +
         polygons + "</mesh></geometry></library_geometries>" +
         "<library_visual_scenes><visual_scene id=\"s\"><node><instance_geometry url=\"#g\"/></node></visual_scene>"
         "</library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
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
} // namespace

TEST_CASE("All kinds of polygons of a .dae file", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string input = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";
  const auto with = [&](const std::string &polygons) { return tetrahedronDae(input, polygons); };
  for (const std::string polygons :
       {"<triangles count=\"4\">I<p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles>",
        "<polylist count=\"4\">I<vcount>3 3 3 3</vcount><p>0 2 1 0 1 3 1 2 3 2 0 3</p></polylist>",
        "<polygons count=\"4\">I<p>0 2 1</p><p>0 1 3</p><p>1 2 3</p><p>2 0 3</p></polygons>",
        "<tristrips count=\"1\">I<p>0 2 1 3 0 2</p></tristrips>",
        "<trifans count=\"2\">I<p>3 0 1 2 0</p><p>0 2 1</p></trifans><lines count=\"1\">I<p>a b</p></lines>"}) {
    CAPTURE(polygons);
    const vpTrackedModel model = vpModelReader::read(folder.write("kinds.dae", with(polygons)));
    CHECK(model.report().closed);
    CHECK(model.triangles().size() == 4);
    CHECK((model.report().size - modelShapes::Point(0.2, 0.3, 0.4)).norm() < 1e-9);
  }
  for (const std::string polygons :
       {"<polylist count=\"4\">I<vcount>3 3 3 4</vcount><p>0 2 1 0 1 3 1 2 3 2 0 3</p></polylist>",
        "<polylist count=\"1\">I<vcount>18446744073709551615</vcount><p>0 2 1</p></polylist>",
        "<polygons count=\"3\">I<p>0 2 1</p></polygons>", "<polygons count=\"1\">I<ph><p>0 2 1</p></ph></polygons>",
        "<triangles count=\"1\">I<p>0 2 4</p></triangles>", "<triangles count=\"1\">I<p>0 2 x</p></triangles>",
        "<triangles count=\"1\"><p>0 2 1</p></triangles>"}) {
    CAPTURE(polygons);
    CHECK_THAT(messageOfFile(folder.write("broken.dae", with(polygons))), ContainsSubstring("broken.dae"));
  }
}

TEST_CASE("Transformations of a .dae file's nodes, and its points, however they are named", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  const std::string good = meshFiles::dae(box(), "");
  const auto centre = [&](const std::string &transformations) {
    const std::string text = replaced(good, "<node id=\"n\">", "<node id=\"n\">" + transformations);
    return vpModelReader::read(folder.write("moved.dae", text)).report().centreOffset;
  };
  const modelShapes::Point middle = centre("");
  CHECK((centre("<matrix>0 -1 0 1 1 0 0 2 0 0 1 3 0 0 0 1</matrix>") -
         modelShapes::Point(1. - middle.y(), 2. + middle.x(), 3. + middle.z()))
            .norm() < 1e-9);
  CHECK((centre("<translate>1 0 0</translate><rotate>0 0 2 90</rotate><scale>2 2 2</scale>") -
         modelShapes::Point(1. - 2. * middle.y(), 2. * middle.x(), 2. * middle.z()))
            .norm() < 1e-9);
  CHECK((centre("<lookat>0 0 5 0 0 0 0 1 0</lookat>") - middle - modelShapes::Point(0., 0., 5.)).norm() < 1e-9);
  for (const std::string broken : {"<translate>0,5 0 0</translate>", "<matrix>1 0 0 0</matrix>",
                                   "<rotate>0 0 1</rotate>", "<skew>45 0 1 0 1 0 0</skew>", "<scale>1 nan 1</scale>"}) {
    CAPTURE(broken);
    const std::string text = replaced(good, "<node id=\"n\">", "<node id=\"n\">" + broken);
    CHECK_THAT(messageOfFile(folder.write("broken.dae", text)), ContainsSubstring("broken.dae"));
  }
  std::string small = good, unnamed = good;
  for (const std::string name : {"X", "Y", "Z"}) {
    small = replaced(small, "name=\"" + name + "\"", std::string("name=\"") + static_cast<char>(name[0] + 32) + "\"");
    unnamed = replaced(unnamed, "name=\"" + name + "\"", "");
  }
  CHECK((vpModelReader::read(folder.write("small.dae", small)).report().centreOffset - middle).norm() < 1e-9);
  CHECK((vpModelReader::read(folder.write("unnamed.dae", unnamed)).report().centreOffset - middle).norm() < 1e-9);
  const std::string flat = replaced(good, "<param name=\"Z\" type=\"float\"/>", "");
  CHECK_THAT(messageOfFile(folder.write("flat.dae", flat)),
             ContainsSubstring("flat.dae") && ContainsSubstring("x to z"));
  const std::string narrow = replaced(good, "stride=\"3\"", "stride=\"2\"");
  CHECK_THAT(messageOfFile(folder.write("narrow.dae", narrow)), ContainsSubstring("narrow.dae"));
}

TEST_CASE("Colours and images of a .dae file; what is missing is told", "[files]")
{
  const meshFiles::TemporaryFolder folder;
  folder.write("my skin.ppm", std::string("P6 1 1 255\n\xFF\x80\x01", 14));
  const auto looks = [&](const std::string &diffuse, const std::string &target = "#m") {
    std::string text = meshFiles::dae(box(), "");
    text = replaced(text, "<triangles ", "<triangles material=\"symbol\" ");
    text =
        replaced(text, "<instance_geometry url=\"#g\"/>",
                 "<instance_geometry url=\"#g\"><bind_material><technique_common><instance_material symbol=\"symbol\" "
                 "target=\"" +
                     target + "\"/></technique_common></bind_material></instance_geometry>");
    text = replaced(text, "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>",
                    "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><input semantic=\"TEXCOORD\" source=\"#p\" "
                    "offset=\"0\" set=\"0\"/>");
    text = replaced(
        text, "<library_geometries>",
        "<library_images><image id=\"i\"><init_from>file://my%20skin.ppm</init_from></image></library_images>"
        "<library_materials><material id=\"m\"><instance_effect url=\"#e\"/></material></library_materials>"
        "<library_effects><effect id=\"e\"><profile_COMMON><newparam sid=\"surface\"><surface type=\"2D\">"
        "<init_from>i</init_from></surface></newparam><newparam sid=\"sampler\"><sampler2D><source>surface"
        "</source></sampler2D></newparam><technique><lambert><diffuse>" +
            diffuse +
            "</diffuse></lambert></technique></profile_COMMON></effect></library_effects><library_geometries>");
    return vpModelReader::read(folder.write("looks.dae", text));
  };
  const vpTrackedModel red = looks("<color>1 0 0 1</color>");
  REQUIRE(red.appearance().color.size() == 12);
  CHECK(red.appearance().color[5][1] == Eigen::Vector3f(1.F, 0.F, 0.F));
  CHECK(red.report().warnings.empty());
  const vpTrackedModel skinned = looks("<texture texture=\"sampler\" texcoord=\"UV\"/>");
  CHECK(skinned.appearance().images.size() == 1);
  CHECK(skinned.report().missingImages == 0);
  CHECK(skinned.report().warnings.empty());
  CHECK(looks("<texture texture=\"i\"/>").appearance().images.size() == 1); // As old files have it.
  for (const vpTrackedModel &model : {looks("<color>1 0 x 1</color>"), looks("<color>1 0</color>"),
                                      looks("<texture texture=\"none\"/>"), looks("<color>1 0 0 1</color>", "#none")}) {
    CHECK(model.report().warnings.size() == 1);
    CHECK(model.triangles().size() == 12);
  }
}
