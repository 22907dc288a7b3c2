// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "generateChecks.h"

#include <visp3/model/vpModelReader.h>
#include <visp3/model/vpModelView.h>

#include <Eigen/Dense>
#include <opencv2/imgcodecs.hpp>

/*!
  \file catchGeneratePrecision.cpp
  The stored pose and the stored image agree. Nothing of the renderer is used: control points say where the silhouette
  has to be, and the gray levels across it say where it is.
*/

namespace {
struct Truth
{
  cv::Mat image; // 32-bit BGR.
  vpHomogeneousMatrix cMo;
  vpCameraParameters cam;
};

Truth readTruth(const std::string &scene, int frame)
{
  Truth truth;
  const std::string key = std::to_string(frame);
  std::ostringstream name;
  name << scene << "/rgb/" << std::setw(6) << std::setfill('0') << frame << ".png";
  cv::imread(name.str()).convertTo(truth.image, CV_32FC3);
  const nlohmann::json k = generateChecks::readJson(scene + "/scene_camera.json")[key]["cam_K"];
  truth.cam = vpCameraParameters(k[0], k[4], k[2], k[5]);
  const nlohmann::json pose = generateChecks::readJson(scene + "/scene_gt.json")[key][0];
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      truth.cMo[i][j] = pose["cam_R_m2c"][3 * i + j];
    }
    truth.cMo[i][3] = pose["cam_t_m2c"][i].get<double>() / 1000.;
  }
  return truth;
}

//! Linear between pixel centres, which are at integers.
Eigen::Vector3d valueAt(const cv::Mat &image, const Eigen::Vector2d &at)
{
  const int j = static_cast<int>(std::floor(at.x()));
  const int i = static_cast<int>(std::floor(at.y()));
  const double a = at.x() - j;
  const double b = at.y() - i;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int di = 0; di < 2; ++di) {
    for (int dj = 0; dj < 2; ++dj) {
      const cv::Vec3f &pixel = image.at<cv::Vec3f>(i + di, j + dj);
      sum +=
          (di ? b : 1. - b) * (dj ? a : 1. - a) * Eigen::Vector3d(double(pixel[0]), double(pixel[1]), double(pixel[2]));
    }
  }
  return sum;
}

const double step = 0.125;

//! \param reach How far the edge is spread to either side, and a pixel more.
//! Distance of the image's edge from a control point along its outward normal. \return False where no step is seen.
bool edgeOffset(const cv::Mat &image, const vpControlPoint &point, double reach, double &offset)
{
  const auto at = [&](double t) { return valueAt(image, point.pixel + t * point.normal); };
  const Eigen::Vector3d object = at(-reach);
  const Eigen::Vector3d background = at(reach);
  const Eigen::Vector3d contrast = object - background;
  // Even on both sides, and different enough.
  if (contrast.norm() < 40. || (at(1. - reach) - object).norm() > 0.04 * contrast.norm() ||
      (at(reach - 1.) - background).norm() > 0.02 * contrast.norm()) {
    return false;
  }
  double coverage = 0.;
  for (double t = -reach + 0.5 * step; t < reach; t += step) {
    coverage += step * (at(t) - background).dot(contrast) / contrast.squaredNorm();
  }
  offset = coverage - reach;
  return true;
}

//! Another edge of another direction so close that it is in the way.
bool isNearCorner(const vpModelView &view, const vpControlPoint &point)
{
  for (const vpControlPoint &other : view.points()) {
    if ((other.pixel - point.pixel).norm() < 8. && std::abs(other.normal.dot(point.normal)) < 0.95) {
      return true;
    }
  }
  return false;
}

struct Offsets
{
  int count = 0;
  double meanAbsolute = 0.;
  double mean = 0.;
  double shift = 0.; // Length of the translation in the image that explains them best.

  bool arePrecise() const { return meanAbsolute < 0.1 && std::abs(mean) < 0.05 && shift < 0.1; }
};

Offsets measure(const std::vector<Truth> &frames, vpModelView &view, vpModelRenderer &renderer, double reach, double du,
                double dv)
{
  Offsets result;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const Truth &truth : frames) {
    vpHomogeneousMatrix cMo = truth.cMo;
    cMo[0][3] += du * cMo[2][3] / truth.cam.get_px();
    cMo[1][3] += dv * cMo[2][3] / truth.cam.get_py();
    vpModelViewOptions options;
    options.visibilitySize = 512;
    options.border = 8.;
    view.compute(cMo, truth.cam, static_cast<unsigned int>(truth.image.cols),
                 static_cast<unsigned int>(truth.image.rows), options, &renderer);
    for (const vpControlPoint &point : view.points()) {
      double offset = 0.;
      if (point.kind != vpEdgeKind::SILHOUETTE || isNearCorner(view, point) ||
          !edgeOffset(truth.image, point, reach, offset)) {
        continue;
      }
      ++result.count;
      result.meanAbsolute += std::abs(offset);
      result.mean += offset;
      normal += point.normal * point.normal.transpose();
      right += point.normal * offset;
    }
  }
  result.meanAbsolute /= std::max(1, result.count);
  result.mean /= std::max(1, result.count);
  result.shift = normal.ldlt().solve(right).norm();
  return result;
}

void check(const std::string &object, int id, const std::string &variant, int count, double reach)
{
  const meshFiles::TemporaryFolder folder;
  bench::SceneOptions options = generateChecks::options(folder.path("data"), object, variant, count);
  options.width = 640;
  options.height = 480;
  bench::generateScene(options);
  std::vector<Truth> frames;
  for (int frame = 0; frame < options.frames; ++frame) {
    frames.push_back(readTruth(options.dataset + "/" + bench::sceneName(options), frame));
  }
  vpModelOptions unit;
  unit.unit = 0.001;
  const std::string file = programs::bopModelPath(options.dataset, id) + ".ply";
  const auto model = std::make_shared<const vpTrackedModel>(vpModelReader::read(file, unit));
  const std::unique_ptr<vpModelRenderer> renderer = vpModelRenderer::create(model, vpModelRenderer::CPU);
  vpModelView view(model);

  const Offsets right = measure(frames, view, *renderer, reach, 0., 0.);
  INFO(object << " " << variant << ": " << right.count << " points, mean " << right.mean << ", mean absolute "
              << right.meanAbsolute << ", shift " << right.shift << " pixels");
  CHECK(right.count > 100);
  CHECK(right.arePrecise());
  CHECK_FALSE(measure(frames, view, *renderer, reach, 0.3, 0.).arePrecise());
  CHECK_FALSE(measure(frames, view, *renderer, reach, 0., 0.3).arePrecise());
  CHECK_FALSE(measure(frames, view, *renderer, reach, -0.2, 0.2).arePrecise());
}
} // namespace

TEST_CASE("The silhouette of a polyhedron is where the stored pose says, to a tenth of a pixel")
{
  check("bands", 2, "regular", 6, 3.);
}

TEST_CASE("The silhouette of a curved object is where the stored pose says, to a tenth of a pixel")
{
  check("figurine", 5, "regular", 6, 3.);
}

TEST_CASE("The stored pose of a blurred image is that of the middle of its exposure")
{
  // A box of one colour, because the edge is spread over as much as the distance of the bands.
  const meshFiles::TemporaryFolder folder;
  const std::string file = folder.write("plain.obj", meshFiles::obj(modelShapes::boxTriangles({0.16, 0.10, 0.06})));
  check(file, bench::makeObject(file, 1).id, "blur", 12, 5.5);
}
