// SPDX-License-Identifier: GPL-2.0-or-later
#include "check/checkedModel.h"

#include <visp3/core/vpCameraParameters.h>
#include <visp3/model/vpModelView.h>

#include <algorithm>
#include <cmath>

namespace programs {
namespace {
// An origin so far from the middle of the object, in diameters, makes small turns of the pose move it out of the image.
constexpr double farOrigin = 10.;
// Of all triangles: so many turned over are no mistake of single ones.
constexpr double manyFlipped = 0.1;
// With fewer control points the tracker's state is LOST whatever they show.
constexpr std::size_t fewestPoints = 8;
// A view in which the object is half as wide as an image of a usual size.
constexpr unsigned int width = 640, height = 480;
constexpr double focal = 600.;

std::string numberText(std::size_t number)
{
  return std::to_string(number);
}

std::string originText(const vpModelReport &found)
{
  return printed("origin %.2f diameters from the middle", found.centreOffset.norm() / found.diameter);
}

void checkMesh(const vpModelReport &found, CheckReport &report)
{
  if (found.triangles == 0) {
    return;
  }
  const std::string holes = numberText(found.holes) + " holes, " + numberText(found.borderEdges) + " border edges";
  report.say("mesh", (found.closed ? "closed" : "open: " + holes) + ", " + numberText(found.flippedTriangles) +
                         " triangles turned over, " + numberText(found.nonManifoldEdges) + " edges of more than two");
  if (found.holes > 0) {
    report.blame("mesh", holes + ": edges of a hole are tracked as if they were the object's; close them in the "
                                 "modelling program");
  }
  if (static_cast<double>(found.flippedTriangles + found.flippedFaces) >
      manyFlipped * static_cast<double>(found.triangles)) {
    report.blame("mesh", numberText(found.flippedTriangles + found.flippedFaces) + " of " +
                             numberText(found.triangles) +
                             " triangles are wound against their neighbours: export it with normals to the outside");
  }
}
} // namespace

void checkGeometry(const vpTrackedModel &model, CheckReport &report)
{
  const vpModelReport &found = model.report();
  report.say("model", lengthText(found.diameter) + " from corner to corner (" + lengthText(found.size.x()) + " x " +
                          lengthText(found.size.y()) + " x " + lengthText(found.size.z()) + "), " +
                          numberText(found.triangles) + " triangles, " + originText(found));
  if (found.centreOffset.norm() > farOrigin * found.diameter) {
    report.blame("origin", "the " + originText(found) + ": move it into the object, and change its poses alike");
  }
  checkMesh(found, report);
  for (const std::string &warning : found.warnings) {
    report.say("model", warning);
  }
}

void checkViews(const std::shared_ptr<const vpTrackedModel> &model, vpModelRenderer::Preference preference,
                CheckReport &report)
{
  const std::unique_ptr<vpModelRenderer> renderer = vpModelRenderer::create(model, preference);
  report.say("renderer", renderer->name());
  vpModelView view(model);
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(focal, focal, 0.5 * width, 0.5 * height);
  const double distance = 2. * model->diameter() * focal / width;
  const Eigen::Vector3d centre = model->centre();
  std::vector<std::size_t> counts;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int turn = 0; turn < 4; ++turn) {
        vpHomogeneousMatrix toMiddle;
        for (unsigned int i = 0; i < 3; ++i) {
          toMiddle[i][3] = -centre[static_cast<Eigen::Index>(i)];
        }
        // No multiples of a right angle, at which a box shows one side alone.
        const vpHomogeneousMatrix seen =
            vpHomogeneousMatrix(0., 0., distance, 0., 0., 0.) * vpHomogeneousMatrix(0., 0., 0., 0.9 * x + 0.2, 0., 0.) *
            vpHomogeneousMatrix(0., 0., 0., 0., 1.571 * turn + 0.4 * y + 0.2, 0.) * toMiddle;
        view.compute(seen, cam, width, height, vpModelViewOptions(), model->isConvex() ? nullptr : renderer.get());
        counts.push_back(view.points().size());
      }
    }
  }
  std::sort(counts.begin(), counts.end());
  report.say("edges", numberText(counts.front()) + " to " + numberText(counts.back()) + " control points in " +
                          numberText(counts.size()) + " views, median " + numberText(counts[counts.size() / 2]));
  if (counts[counts.size() / 2] < fewestPoints) {
    report.blame("edges", "half of the views show fewer than " + numberText(fewestPoints) +
                              " control points of edges: lower the crease angle, or track with colours and points");
  }
}

} // namespace programs
