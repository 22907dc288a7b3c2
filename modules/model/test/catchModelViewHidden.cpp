// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "modelShapes.h"
#include "viewChecks.h"

#include <algorithm>
#include <string>

using namespace modelShapes;
using namespace viewChecks;

namespace {
// Edges closer than this to an edge that hides them may be there or not, pixels, where the depth buffer has half of
// the image's resolution.
const double blurAtHalf = 5.;
// The object fills the image, is of the usual size, or is small.
const std::vector<double> distances = {0.22, 0.45, 1.2};

//! The same for a depth buffer of visibilitySize that holds all control points.
double blurOf(const Looker &looker)
{
  Eigen::AlignedBox2d box;
  for (const vpControlPoint &point : looker.points()) {
    box.extend(point.pixel);
  }
  return blurAtHalf * std::max(1., 0.5 * box.sizes().maxCoeff() / looker.options.visibilitySize);
}

vpTrackedModel shape(const std::string &name)
{
  if (name == "letter L") {
    return build(lPolygons(0.12, 0.05));
  }
  if (name == "letter L as a mesh") {
    std::vector<Triangle> triangles;
    for (const Point &centre : {Point(0.03, 0.03, 0.), Point(0.09, 0.03, 0.), Point(0.03, 0.09, 0.)}) {
      const std::vector<Triangle> cell = boxTriangles(Point(0.06, 0.06, 0.05), 2, centre);
      triangles.insert(triangles.end(), cell.begin(), cell.end());
    }
    return build(triangles);
  }
  if (name == "window") {
    return build(framePolygons(0.14, 0.03));
  }
  std::vector<Polygon> boxes = boxPolygons(Point(0.06, 0.05, 0.04), Point(0., 0., 0.08));
  for (const Polygon &side : boxPolygons(Point(0.12, 0.1, 0.03), Point(0.01, 0.02, -0.02))) {
    boxes.push_back(side);
  }
  return build(boxes);
}

//! True where a face of the edge is turned to the camera, and none is seen so flat that it could be either.
bool facesCamera(const Looker &looker, const vpModelEdge &edge)
{
  bool faces = false;
  for (int i = edge.firstFace; i < edge.firstFace + edge.faceCount; ++i) {
    const std::size_t index = static_cast<std::size_t>(looker.model().edgeFaces()[static_cast<std::size_t>(i)]);
    const vpModelFace &face = looker.model().faces()[index];
    const double cosine = face.normal.dot((looker.centre() - face.centre).normalized());
    if (std::fabs(cosine) < 0.03) {
      return false;
    }
    faces = faces || cosine > 0.;
  }
  return faces;
}

struct EdgeSample
{
  Pixel pixel;
  bool visible;
};

bool isInImage(const Looker &looker, const Pixel &pixel)
{
  const double border = looker.options.border;
  return pixel.minCoeff() >= border && pixel.x() <= looker.width - 1. - border &&
         pixel.y() <= looker.height - 1. - border;
}

//! Points 0.25 mm apart along an edge, and whether each is in the image and the ray to it meets nothing before.
std::vector<EdgeSample> castAlong(const Looker &looker, const vpModelEdge &edge)
{
  const Point &a = looker.model().vertices()[static_cast<std::size_t>(edge.vertex[0])];
  const Point along = looker.model().vertices()[static_cast<std::size_t>(edge.vertex[1])] - a;
  const int count = static_cast<int>(along.norm() / 0.00025);
  std::vector<EdgeSample> samples;
  for (int i = 1; i < count; ++i) {
    const Point oX = a + along * i / count;
    const Pixel pixel = looker.project(oX);
    samples.push_back({pixel, isInImage(looker, pixel) && looker.castRay(pixel) > looker.toCamera(oX).z() - 1e-4});
  }
  return samples;
}

//! True where all of the edge within a distance of one of its samples is visible.
bool isWellInside(const std::vector<EdgeSample> &samples, std::size_t index, double distance)
{
  const Pixel &pixel = samples[index].pixel;
  const bool endIsNear =
      (samples.front().pixel - pixel).norm() < distance || (samples.back().pixel - pixel).norm() < distance;
  return !endIsNear && std::all_of(samples.begin(), samples.end(), [&](const EdgeSample &sample) {
    return sample.visible || (sample.pixel - pixel).norm() > distance;
  });
}

const std::vector<std::string> shapes = {"letter L", "letter L as a mesh", "window", "two boxes"};
const std::vector<Point> directions = {Point(1., 0.8, 0.7),    Point(-0.7, 0.5, 1.),  Point(0.3, -0.4, 1.),
                                       Point(0.9, -0.25, 0.3), Point(0.5, 0.6, -0.8), Point(-0.2, -0.9, -0.5)};
} // namespace

TEST_CASE("Control points that another part of the object hides are gone")
{
  const std::string name = GENERATE_COPY(from_range(shapes));
  const Point direction = GENERATE_COPY(from_range(directions));
  const double distance = GENERATE_COPY(from_range(distances));
  CAPTURE(name, direction, distance);
  Looker looker(shape(name));
  REQUIRE_FALSE(looker.model().isConvex());
  looker.look(lookFrom(direction, distance, 0.3, looker.model().report().centreOffset));
  REQUIRE(looker.points().size() > 20);
  const double blur = blurOf(looker);
  CHECK(contoursHoldAllPoints(looker.view()));
  CHECK(arcLengthError(looker.view()) < 1e-6);
  CHECK(projectionError(looker) < 1e-9);
  int wrong = 0;
  for (const vpControlPoint &point : looker.points()) {
    wrong += isWellHidden(looker, point.position, blur, 0.002) ? 1 : 0;
  }
  CHECK(wrong == 0);
}

TEST_CASE("Every edge that nothing hides has its control points")
{
  const std::string name = GENERATE_COPY(from_range(shapes));
  const Point direction = GENERATE_COPY(from_range(directions));
  const double distance = GENERATE_COPY(from_range(distances));
  CAPTURE(name, direction, distance);
  Looker looker(shape(name));
  const vpModelView &view = looker.look(lookFrom(direction, distance, 0.3, looker.model().report().centreOffset));
  const double blur = blurOf(looker);
  int visible = 0;
  for (std::size_t e = 0; e < looker.model().edges().size(); ++e) {
    const vpModelEdge &edge = looker.model().edges()[e];
    if (!facesCamera(looker, edge)) {
      continue;
    }
    const std::vector<EdgeSample> samples = castAlong(looker, edge);
    int missing = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (samples[i].visible && isWellInside(samples, i, blur)) {
        ++visible;
        const double nearest = nearestPoint(
            view, samples[i].pixel, [e](const vpControlPoint &point) { return point.edge == static_cast<int>(e); });
        missing += nearest > 4. ? 1 : 0;
      }
    }
    CAPTURE(e);
    CHECK(missing == 0);
  }
  CHECK(visible > 100);
}

TEST_CASE("Silhouettes have background beside them, inner edges have surface on both sides")
{
  const std::string name = GENERATE_COPY(from_range(shapes));
  const Point direction = GENERATE_COPY(from_range(directions));
  const double distance = GENERATE_COPY(from_range(distances));
  CAPTURE(name, direction, distance);
  Looker looker(shape(name));
  looker.look(lookFrom(direction, distance, 0.3, looker.model().report().centreOffset));
  CHECK(normalError(looker) < 1e-6);
  int wrong = 0;
  int clear = 0;
  for (const vpControlPoint &point : looker.points()) {
    const auto surfaceAt = [&](double along, double across) {
      const Pixel tangent = looker.tangent(point).normalized();
      return std::isfinite(looker.castRay(point.pixel + along * tangent + across * point.normal));
    };
    // Where another edge is near, the one or the other may be meant.
    const bool ahead = surfaceAt(0., 1.);
    bool alone = true;
    for (const double across : {0.2, 3., 6.}) {
      for (const double along : {-6., -3., 0., 3., 6.}) {
        alone = alone && surfaceAt(along, across) == ahead && surfaceAt(along, -across);
      }
    }
    clear += alone ? 1 : 0;
    wrong += alone && (point.kind == vpEdgeKind::SILHOUETTE) == ahead ? 1 : 0;
  }
  CHECK(clear > 10);
  CHECK(wrong == 0);
}

TEST_CASE("A view knows its pose, and its depth where it had to draw it")
{
  Looker letter(shape("letter L"));
  CHECK(letter.view().depth() == nullptr);
  for (const double distance : distances) {
    const vpHomogeneousMatrix cMo(-0.05, -0.05, distance, 0.4, 0.2, 0.1);
    letter.look(cMo);
    for (unsigned int i = 0; i < 4; ++i) {
      for (unsigned int j = 0; j < 4; ++j) {
        CHECK(letter.view().pose()[i][j] == exactly(cMo[i][j]));
      }
    }
    REQUIRE(letter.view().depth() != nullptr);
    const Pixel pixel = letter.project(Point(0.03, 0.03, 0.));
    const int at = letter.view().depth()->index(pixel.x(), pixel.y());
    REQUIRE(at >= 0);
    CHECK(letter.view().depth()->depth[static_cast<std::size_t>(at)] == Approx(letter.castRay(pixel)).epsilon(0.01));
  }
  Looker box(build(boxPolygons(Point(0.1, 0.1, 0.1))));
  box.look(vpHomogeneousMatrix(0., 0., 0.5, 0.4, 0.2, 0.1));
  CHECK(box.view().depth() == nullptr); // Nothing of it can hide anything.
}

TEST_CASE("A depth buffer serves near poses", "[view]")
{
  for (const std::string &name : {std::string("letter L"), std::string("letter L as a mesh"), std::string("window")}) {
    const std::shared_ptr<const vpTrackedModel> model = std::make_shared<const vpTrackedModel>(shape(name));
    vpCpuRenderer renderer(model);
    const vpCameraParameters cam(600., 600., 319.5, 239.5);
    const vpHomogeneousMatrix cMo(-0.04, -0.03, 0.45, 0.5, 0.4, 0.3);
    // Some 3 pixels to the side and nearer, and turned a bit.
    const vpHomogeneousMatrix moved = vpHomogeneousMatrix(0.002, -0.001, -0.002, 0., 0., 0.) * cMo *
                                      vpHomogeneousMatrix(0., 0., 0., 0.003, -0.003, 0.003);
    vpModelView kept(model);
    kept.compute(cMo, cam, 640, 480, vpModelViewOptions(), &renderer);
    kept.compute(moved, cam, 640, 480, vpModelViewOptions(), &renderer, true);
    vpModelView drawn(model);
    drawn.compute(moved, cam, 640, 480, vpModelViewOptions(), &renderer);
    const auto missing = [](const vpModelView &from, const vpModelView &in) {
      return static_cast<double>(
          std::count_if(from.points().begin(), from.points().end(), [&](const vpControlPoint &a) {
            return std::none_of(in.points().begin(), in.points().end(), [&](const vpControlPoint &b) {
              return (a.pixel - b.pixel).norm() < 2.5 && a.kind == b.kind; // Half a step, and a bit.
            });
          }));
    };
    INFO(name << ": " << missing(drawn, kept) << " of " << drawn.points().size() << " are missing, "
              << missing(kept, drawn) << " of " << kept.points().size() << " too many");
    CHECK(drawn.points().size() > 50);
    CHECK(missing(drawn, kept) < 0.05 * static_cast<double>(drawn.points().size()));
    CHECK(missing(kept, drawn) < 0.05 * static_cast<double>(kept.points().size()));
    CHECK(kept.depthPose() != drawn.depthPose());
  }
}
