// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include <meshFiles.h>
#include <modelShapes.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <opencv2/core/utility.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {
const unsigned int width = 640;
const unsigned int height = 480;

vpCameraParameters camera()
{
  return vpCameraParameters(600., 600., 319.5, 239.5);
}

// A surface without a single edge whose outline tells all six degrees of freedom.
std::vector<modelShapes::Triangle> makeLump()
{
  const int rings = 60;
  const int sectors = 90;
  const auto at = [&](int i, int j) {
    const double theta = M_PI * i / rings;
    const double phi = 2. * M_PI * (j % sectors) / sectors;
    const double radius =
        0.06 * (1. + 0.3 * std::cos(3. * phi) * std::pow(std::sin(theta), 3.) + 0.25 * std::cos(2. * theta + 0.5));
    return Eigen::Vector3d(radius * std::sin(theta) * std::cos(phi), radius * std::sin(theta) * std::sin(phi),
                           1.3 * radius * std::cos(theta));
  };
  std::vector<modelShapes::Triangle> triangles;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
      triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    }
  }
  return triangles;
}

std::string writeStl(const std::vector<modelShapes::Triangle> &triangles, const std::string &name)
{
  std::ofstream file(name);
  file << std::setprecision(12) << "solid shape\n";
  for (const modelShapes::Triangle &triangle : triangles) {
    file << "facet normal 0 0 0\nouter loop\n";
    for (const Eigen::Vector3d &corner : triangle) {
      file << "vertex " << corner.x() << " " << corner.y() << " " << corner.z() << "\n";
    }
    file << "endloop\nendfacet\n";
  }
  file << "endsolid shape\n";
  return name;
}

// Shaded a little by the angle to the line of sight (shade that falls off at the rim moves the edge of the image
// itself), with anti-aliasing, on a dark background.
class Painter
{
public:
  explicit Painter(const std::shared_ptr<const vpTrackedModel> &model) : m_renderer(model) {}

  vpImage<unsigned char> draw(const vpHomogeneousMatrix &cMo)
  {
    const int factor = 3;
    const vpCameraParameters cam = camera();
    const vpCameraParameters fine(factor * cam.get_px(), factor * cam.get_py(), factor * (cam.get_u0() + 0.5) - 0.5,
                                  factor * (cam.get_v0() + 0.5) - 0.5);
    vpRenderOptions options;
    options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL;
    m_renderer.render(cMo, fine, factor * width, factor * height, options, m_view);
    std::vector<double> sum(width * height, 0.);
    for (int y = 0; y < m_view.height; ++y) {
      for (int x = 0; x < m_view.width; ++x) {
        const std::size_t i = static_cast<std::size_t>(y * m_view.width + x);
        const std::size_t pixel = static_cast<std::size_t>((y + m_view.top) / factor) * width +
                                  static_cast<std::size_t>((x + m_view.left) / factor);
        sum[pixel] += m_view.depth[i] > 0.F ? 150. - 30. * static_cast<double>(m_view.normal[i].z()) : 0.;
      }
    }
    vpImage<unsigned char> I(height, width);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      I.bitmap[i] = static_cast<unsigned char>(20. + sum[i] / (factor * factor));
    }
    return I;
  }

private:
  vpCpuRenderer m_renderer;
  vpRenderedView m_view;
};

vpHomogeneousMatrix poseAt(int frame)
{
  const double t = 0.12 * frame;
  vpColVector motion(6);
  motion[0] = 0.03 * std::sin(t);
  motion[1] = 0.02 * std::sin(1.3 * t);
  motion[2] = 0.05 * std::sin(0.7 * t);
  motion[3] = 0.2 * std::sin(0.9 * t);
  motion[4] = 0.2 * std::sin(1.1 * t);
  motion[5] = 0.2 * std::sin(0.8 * t);
  return vpHomogeneousMatrix(0.02, -0.01, 0.6, 0.9, 0.5, -0.2) * vpExponentialMap::direct(motion);
}

void proposeSeveralPoses(vpMbMultiCueTracker &tracker, bool flag)
{
  vpPoseHypothesisSettings settings;
  settings.enabled = flag;
  tracker.setPoseHypothesisSettings(settings);
}

// Tracks 25 frames; calls check(cMo, truth) after each.
template <typename Check> void follow(vpMbMultiCueTracker &tracker, const Check &check)
{
  Painter painter(tracker.getModel());
  for (int i = 0; i < 25; ++i) {
    const vpImage<unsigned char> I = painter.draw(poseAt(i));
    if (i == 0) {
      tracker.initFromPose(I, poseAt(0));
    }
    tracker.track(I);
    CAPTURE(i);
    REQUIRE(tracker.getTrackingState() == vpTrackingState::TRACKING);
    check(tracker.getPose(), poseAt(i));
  }
}

Eigen::Vector3d axisOf(const vpHomogeneousMatrix &cMo)
{
  return Eigen::Vector3d(cMo[0][2], cMo[1][2], cMo[2][2]);
}
} // namespace

TEST_CASE("A mesh without edges is tracked by its rims, with one pose hypothesis and with several", "[tracker]")
{
  const bool several = GENERATE(false, true);
  CAPTURE(several);
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.setCameraParameters(camera());
  proposeSeveralPoses(tracker, several);
  tracker.loadModel(writeStl(makeLump(), meshFiles::temporaryFile("lump.stl")));
  REQUIRE(tracker.getModelReport().edges == 0);
  follow(tracker, [](const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth) {
    CHECK((cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm() < 0.002);
    CHECK(vpMath::deg((truth.inverse() * cMo).getThetaUVector().getTheta()) < 1.5);
  });
}

TEST_CASE("The view of a mesh does not depend on the number of threads", "[tracker]")
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.loadModel(writeStl(makeLump(), meshFiles::temporaryFile("lump-threads.stl")));
  const int threadsBefore = cv::getNumThreads();
  std::vector<vpControlPoint> expected;
  for (const int threads : {1, 2, 4}) {
    CAPTURE(threads);
    cv::setNumThreads(threads);
    vpCpuRenderer renderer(tracker.getModel());
    vpModelView view(tracker.getModel());
    for (int i = 0; i < 10; ++i) {
      view.compute(poseAt(i), camera(), width, height, vpModelViewOptions(), &renderer);
    }
    expected = threads == 1 ? view.points() : expected;
    REQUIRE(view.points().size() == expected.size());
    REQUIRE(expected.size() > 20);
    CHECK(std::equal(expected.begin(), expected.end(), view.points().begin(),
                     [](const vpControlPoint &a, const vpControlPoint &b) {
                       return a.position == b.position && a.normal == b.normal && a.contour == b.contour;
                     }));
  }
  cv::setNumThreads(threadsBefore);
}

TEST_CASE("A cylinder of a .cao file is tracked by limbs and circles, and does not spin", "[tracker]")
{
  const bool several = GENERATE(false, true);
  CAPTURE(several);
  const std::string name = meshFiles::temporaryFile("can.cao");
  std::ofstream file(name);
  file << "V1\n6\n0 0 -0.06\n0 0 0.06\n0.04 0 0.06\n0 0.04 0.06\n0.04 0 -0.06\n0 0.04 -0.06\n"
       << "0\n0\n0\n1\n0 1 0.04\n2\n0.04 1 2 3\n0.04 0 5 4\n";
  file.close();
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.setCameraParameters(camera());
  proposeSeveralPoses(tracker, several);
  tracker.loadModel(name);
  REQUIRE(tracker.getModelReport().cylinders == 1);
  REQUIRE(tracker.getModelReport().circles == 2);
  follow(tracker, [](const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth) {
    CHECK((cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm() < 0.002);
    CHECK(vpMath::deg(std::acos(std::min(1., axisOf(cMo).dot(axisOf(truth))))) < 0.5);
    // Nothing shows the turn about the axis: it keeps what it had in the first frame.
    const vpThetaUVector turn = (poseAt(0).inverse() * cMo).getThetaUVector();
    CHECK(std::fabs(vpMath::deg(turn[2])) < 6.);
  });
}
