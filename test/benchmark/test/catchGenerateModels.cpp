// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "generateChecks.h"

#include <visp3/mbt/vpMbGenericTracker.h>
#include <visp3/model/vpModelReader.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace {
using Point = Eigen::Vector3d;

struct Files
{
  std::string cao;
  vpTrackedModel mesh;
};

//! Writes an object's files and reads the mesh back.
Files makeFiles(const meshFiles::TemporaryFolder &folder, const std::string &name)
{
  const bench::SyntheticObject object = bench::makeObject(name, 1);
  bench::writeAndLoad(folder.path("data"), object);
  const std::string path = programs::bopModelPath(folder.path("data"), object.id);
  vpModelOptions options;
  options.unit = 0.001;
  return {path + ".cao", vpModelReader::read(path + ".ply", options)};
}

double distanceFrom(const Point &start, const Point &end, const Point &p)
{
  const Point axis = end - start;
  const double share = std::clamp((p - start).dot(axis) / axis.squaredNorm(), 0., 1.);
  return (p - start - share * axis).norm();
}

//! Distance of a point from the nearest tracked edge of a model.
double distanceFromEdges(const vpTrackedModel &model, const Point &p)
{
  double nearest = 1e9;
  for (const vpModelEdge &edge : model.edges()) {
    nearest = std::min(nearest, distanceFrom(model.vertices()[static_cast<std::size_t>(edge.vertex[0])],
                                             model.vertices()[static_cast<std::size_t>(edge.vertex[1])], p));
  }
  return nearest;
}

//! Largest distance of points of the edges of one model from the edges of another one.
double largestDistance(const vpTrackedModel &from, const vpTrackedModel &to)
{
  double largest = 0.;
  for (const vpModelEdge &edge : from.edges()) {
    const Point &start = from.vertices()[static_cast<std::size_t>(edge.vertex[0])];
    const Point &end = from.vertices()[static_cast<std::size_t>(edge.vertex[1])];
    for (const double share : {0., 0.25, 0.5, 0.75, 1.}) {
      largest = std::max(largest, distanceFromEdges(to, start + share * (end - start)));
    }
  }
  return largest;
}

//! Positive where the triangles look outwards.
double volume(const vpTrackedModel &model)
{
  double sum = 0.;
  for (const vpModelTriangle &triangle : model.triangles()) {
    const auto at = [&](std::size_t i) { return model.vertices()[static_cast<std::size_t>(triangle.vertex[i])]; };
    sum += at(0).dot(at(1).cross(at(2))) / 6.;
  }
  return sum;
}
} // namespace

TEST_CASE("The .cao files load in ViSP's tracker, look outwards and have the edges of the meshes")
{
  const meshFiles::TemporaryFolder folder;
  for (const std::string name : {"box", "bands", "window", "satellite"}) {
    INFO(name);
    const Files files = makeFiles(folder, name);
    vpMbGenericTracker visp(1, vpMbGenericTracker::EDGE_TRACKER);
    visp.loadModel(files.cao);
    vpMbMultiCueTracker ours;
    ours.loadModel(files.cao);
    const vpTrackedModel &polygons = *ours.getModel();
    CHECK(visp.getNbPolygon() >= polygons.report().faces - polygons.report().circles - polygons.report().cylinders);
    CHECK(polygons.report().flippedFaces == 0);
    CHECK(polygons.report().triangles > 0);
    CHECK(volume(polygons) > 0.);
    const double tolerance = 1e-6;
    if (name != "bands") { // whose bands are no creases
      CHECK(largestDistance(polygons, files.mesh) < tolerance);
    }
    if (name != "satellite") { // whose round parts are no polygons
      CHECK(largestDistance(files.mesh, polygons) < tolerance);
      CHECK(volume(polygons) == Approx(volume(files.mesh)));
    }
  }
}

TEST_CASE("The bands' edges are between colours of the mesh")
{
  const meshFiles::TemporaryFolder folder;
  const Files files = makeFiles(folder, "bands");
  vpMbMultiCueTracker tracker;
  tracker.loadModel(files.cao);
  const vpTrackedModel &polygons = *tracker.getModel();
  CHECK(polygons.edges().size() > 40);
  for (const Point &vertex : polygons.vertices()) {
    double nearest = 1e9;
    for (const Point &other : files.mesh.vertices()) {
      nearest = std::min(nearest, (vertex - other).norm());
    }
    CHECK(nearest < 1e-6);
  }
}

TEST_CASE("The window has about 30 faces, the figurine about 15,000 vertices and no crease")
{
  const meshFiles::TemporaryFolder folder;
  CHECK(makeFiles(folder, "window").mesh.faces().size() == 30);
  const vpTrackedModel figurine = makeFiles(folder, "figurine").mesh;
  CHECK(figurine.vertices().size() > 13000);
  CHECK(figurine.vertices().size() < 17000);
  CHECK(figurine.report().closed);
  CHECK(figurine.report().nonManifoldEdges == 0);
  CHECK(figurine.edges().size() < 100);
}

TEST_CASE("models_info.json has the sizes of all objects in millimetres")
{
  const meshFiles::TemporaryFolder folder;
  makeFiles(folder, "box");
  makeFiles(folder, "satellite");
  const nlohmann::json info = generateChecks::readJson(folder.path("data/models/models_info.json"));
  CHECK(info["1"]["diameter"].get<double>() == Approx(std::sqrt(160. * 160. + 100. * 100. + 60. * 60.)));
  CHECK(info["1"]["min_x"].get<double>() == Approx(-80.));
  CHECK(info["1"]["size_z"].get<double>() == Approx(60.));
  CHECK(info["4"]["size_x"].get<double>() == Approx(2900.));
}

TEST_CASE("A textured mesh keeps its texture")
{
  const meshFiles::TemporaryFolder folder;
  const bench::SyntheticObject box = bench::makeObject("box", 1);
  bench::writeAndLoad(folder.path("data"), box);
  const bench::SyntheticObject again =
      bench::makeObject(programs::bopModelPath(folder.path("data"), 1) + ".obj", 1, 1.);
  REQUIRE(again.images.size() == box.images.size());
  CHECK(cv::norm(again.images[0], box.images[0], cv::NORM_INF) == exactly(0.));
  CHECK(again.triangles.size() == box.triangles.size());
}
