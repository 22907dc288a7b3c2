// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include <meshFiles.h>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace {
const unsigned int width = 640;
const unsigned int height = 480;

vpCameraParameters camera()
{
  return vpCameraParameters(600., 600., 319.5, 239.5);
}

// A can of 8 x 12 cm with stripes along its axis, each an eighth of its circumference wide: nothing of its geometry
// tells how far it is turned about its axis.
std::string writeCan(const std::string &name)
{
  const int sectors = 96;
  std::ofstream file(name);
  file << meshFiles::coloredPlyHeader(6 * sectors, 3 * sectors);
  const auto write = [&](double radius, int i, double z, int gray) {
    const double angle = 2. * M_PI * i / sectors;
    file << radius * std::cos(angle) << " " << radius * std::sin(angle) << " " << z << " " << gray << " " << gray << " "
         << gray << "\n";
  };
  for (int i = 0; i < sectors; ++i) {
    const int gray = (i / (sectors / 8)) % 2 == 0 ? 90 : 190;
    for (const int k : {i, i + 1}) {
      write(0.04, k, -0.06, gray);
      write(0.04, k, 0.06, gray);
    }
    write(0., i, -0.06, gray);
    write(0., i, 0.06, gray);
  }
  for (int i = 0; i < sectors; ++i) {
    const int v = 6 * i;
    file << "4 " << v << " " << v + 2 << " " << v + 3 << " " << v + 1 << "\n3 " << v << " " << v + 4 << " " << v + 2
         << "\n3 " << v + 1 << " " << v + 3 << " " << v + 5 << "\n";
  }
  return name;
}

// The model's colours with anti-aliasing, on a dark background.
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
    options.channels = vpRenderOptions::COLOR;
    m_renderer.render(cMo, fine, factor * width, factor * height, options, m_view);
    std::vector<double> sum(width * height, 0.);
    for (int y = 0; y < m_view.height; ++y) {
      for (int x = 0; x < m_view.width; ++x) {
        const std::size_t pixel = static_cast<std::size_t>((y + m_view.top) / factor) * width +
                                  static_cast<std::size_t>((x + m_view.left) / factor);
        sum[pixel] += m_view.color[static_cast<std::size_t>(y * m_view.width + x)].R;
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
  motion[3] = 0.1 * std::sin(0.9 * t);
  motion[4] = 0.1 * std::sin(1.1 * t);
  motion[5] = 0.4 * std::sin(0.8 * t); // About the can's axis.
  return vpHomogeneousMatrix(0.02, -0.01, 0.6, 1.3, 0.4, -0.2) * vpExponentialMap::direct(motion);
}

struct Turns // About the can's axis, degrees.
{
  double error = 0.; // The largest in frames 5 to 24, when the first ones have settled.
  double path = 0.;  // All steps of the estimated turn added up.
};

double turnOf(const vpHomogeneousMatrix &oMo)
{
  return std::fabs(vpMath::deg(oMo.getThetaUVector()[2]));
}

Turns trackCan(bool textureEdges)
{
  vpMbMultiCueTracker tracker(vpMbMultiCueTracker::EDGE_TRACKER);
  tracker.setCameraParameters(camera());
  tracker.setTextureEdges(textureEdges);
  tracker.loadModel(writeCan(meshFiles::temporaryFile("can.ply")));
  Painter painter(tracker.getModel());
  Turns turns;
  for (int i = 0; i < 25; ++i) {
    const vpImage<unsigned char> I = painter.draw(poseAt(i));
    if (i == 0) {
      tracker.initFromPose(I, poseAt(0));
    }
    const vpHomogeneousMatrix before = tracker.getPose();
    tracker.track(I);
    CAPTURE(i);
    CHECK(tracker.getTrackingState() == vpTrackingState::TRACKING);
    turns.path += turnOf(before.inverse() * tracker.getPose());
    turns.error = i < 5 ? 0. : std::max(turns.error, turnOf(poseAt(i).inverse() * tracker.getPose()));
  }
  return turns;
}
} // namespace

TEST_CASE("Print on a round object tells the turn that its outline does not", "[tracker]")
{
  CHECK(trackCan(true).error < 0.5);
}

TEST_CASE("A round object whose print is not looked at does not spin", "[tracker]")
{
  const Turns turns = trackCan(false);
  CHECK(turns.path < 1.);
  CHECK(turns.error > 5.); // The true turn is not seen.
}
