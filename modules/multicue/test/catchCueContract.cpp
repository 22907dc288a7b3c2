// SPDX-License-Identifier: GPL-2.0-or-later
#include "estimate/vpModelLooks.cpp" // The library keeps it to itself.

#include "centroidCue.h"

#include <catchMain.h>
#include <pointScenes.h>

#include <visp3/cues/vpColorCue.h>

#include <visp3/core/vpException.h>
#include <visp3/core/vpExponentialMap.h>

#include <limits>

namespace {
// What the tracker relies on, of every kind of cue that there is.
class Scene
{
public:
  Scene() : m_model(pointScenes::makeBox()), m_painter(m_model), m_renderer(m_model)
  {
    looks.setModel(m_model);
    looks.setSize(pointScenes::width, pointScenes::height);
  }

  static vpHomogeneousMatrix poseAt(int frame)
  {
    vpColVector motion(6);
    motion[0] = 0.001 * frame;
    motion[4] = 0.006 * frame;
    return pointScenes::startPose() * vpExponentialMap::direct(motion);
  }

  // Marble, reddish where it is the object's.
  vpCueFrame frame(int number)
  {
    const vpImage<unsigned char> gray = m_painter.draw(poseAt(number));
    vpRenderedView object;
    m_renderer.render(poseAt(number), pointScenes::makeCamera(), pointScenes::width, pointScenes::height, {}, object);
    vpImage<vpRGBa> &I = newImage();
    for (unsigned int i = 0; i < I.getHeight(); ++i) {
      for (unsigned int j = 0; j < I.getWidth(); ++j) {
        const unsigned char g = gray[i][j];
        const int at = object.index(j, i);
        const bool isObject = at >= 0 && object.depth[static_cast<std::size_t>(at)] > 0.F;
        I[i][j] =
            vpRGBa(isObject ? static_cast<unsigned char>(100 + g / 2) : 0, g, static_cast<unsigned char>(255 - g));
      }
    }
    return source.frame(I, pointScenes::makeCamera(), nullptr);
  }

  vpCueFrame plain(unsigned char level)
  {
    vpImage<vpRGBa> &I = newImage();
    I = vpRGBa(level, level, level);
    return source.frame(I, pointScenes::makeCamera(), nullptr);
  }

  const vpModelView &view(const vpCueFrame &image, const vpHomogeneousMatrix &cMo)
  {
    looks.setImage(image);
    return looks.compute({image, m_timings, m_deadline, m_streams}, cMo);
  }

  // As in the first two frames of a tracker; the second one is matched at the pose before.
  void follow(vpTrackedCue &cue, int last = 1)
  {
    for (int number = 0; number <= last; ++number) {
      const vpCueFrame image = frame(number);
      const vpModelView &seen = view(image, poseAt(std::max(number - 1, 0)));
      if (number > 0 || cue.matchStart(image, seen)) {
        cue.cue().match(image, seen);
      }
      if (number < last) {
        learn(cue, poseAt(number));
      }
    }
  }

  void learn(vpTrackedCue &cue, const vpHomogeneousMatrix &cMo)
  {
    vpResidualBlock block;
    cue.cue().residuals(cMo, block);
    cue.learn(cMo, std::vector<double>(block.rows.size(), 1.), looks);
  }

  vpModelLooks looks;
  vpFrameSource source;

private:
  // Frames look into the image that they are of.
  vpImage<vpRGBa> &newImage()
  {
    m_images.emplace_back(pointScenes::height, pointScenes::width);
    return m_images.back();
  }

  std::deque<vpImage<vpRGBa>> m_images;
  pointScenes::Model m_model;
  pointScenes::Painter m_painter;
  vpCpuRenderer m_renderer;
  vpTrackingTimings m_timings;
  vpFrameDeadline m_deadline;
  vpRandomStreams m_streams;
};

std::unique_ptr<vpTrackedCue> make(const vpCueKind &kind, Scene &scene)
{
  std::unique_ptr<vpTrackedCue> cue = kind.make();
  cue->setUsed(true, scene.looks);
  if (auto *colors = dynamic_cast<vpColorCue *>(&cue->cue())) {
    // Else a row stands for many pixels, with the pull of all of them; catchColorCueJacobian has that.
    vpColorCueSettings settings = colors->settings();
    settings.rows = vpColorCueSettings::PIXELS;
    colors->setSettings(settings);
  }
  return cue;
}

std::vector<double> errors(vpTrackedCue &cue, const vpHomogeneousMatrix &cMo)
{
  vpResidualBlock block;
  cue.cue().residuals(cMo, block);
  std::vector<double> all;
  for (const vpResidual &row : block.rows) {
    all.push_back(row.error);
  }
  return all;
}

vpHomogeneousMatrix moved(const vpHomogeneousMatrix &cMo, unsigned int axis, double step)
{
  vpColVector v(6);
  v[axis] = step;
  return vpExponentialMap::direct(v).inverse() * cMo;
}

void addCentroid()
{
  if (vpCueKinds::find(vpTrackedCentroid::type) == nullptr) {
    vpCueKinds::add(vpTrackedCentroid::kind());
  }
}
} // namespace

TEST_CASE("A cue's interaction matrix is the derivative of its errors", "[cues]")
{
  addCentroid();
  for (const vpCueKind &kind : vpCueKinds::all()) {
    DYNAMIC_SECTION(kind.name)
    {
      Scene scene;
      const auto cue = make(kind, scene);
      scene.follow(*cue);
      const vpHomogeneousMatrix cMo = Scene::poseAt(1);
      vpResidualBlock block;
      cue->cue().residuals(cMo, block);
      REQUIRE(block.rows.size() >= 2);
      const double step = 1e-6;
      for (unsigned int axis = 0; axis < 6; ++axis) {
        const std::vector<double> more = errors(*cue, moved(cMo, axis, step));
        const std::vector<double> less = errors(*cue, moved(cMo, axis, -step));
        REQUIRE(more.size() == block.rows.size());
        double off = 0.;
        double largest = 0.;
        for (std::size_t i = 0; i < more.size(); ++i) {
          const double slope = (more[i] - less[i]) / (2. * step);
          off += std::fabs(slope - block.rows[i].jacobian[axis]);
          largest = std::max(largest, std::fabs(block.rows[i].jacobian[axis]));
        }
        INFO("axis " << axis);
        CHECK(off / static_cast<double>(more.size()) < 0.01 * largest);
      }
    }
  }
}

TEST_CASE("Asking a cue for its equations changes nothing", "[cues]")
{
  addCentroid();
  for (const vpCueKind &kind : vpCueKinds::all()) {
    DYNAMIC_SECTION(kind.name)
    {
      Scene scene;
      const auto cue = make(kind, scene);
      scene.follow(*cue);
      const std::vector<double> first = errors(*cue, Scene::poseAt(1));
      const std::vector<double> elsewhere = errors(*cue, Scene::poseAt(4));
      CHECK(cue->agreement(Scene::poseAt(4), pointScenes::makeCamera()).has_value());
      CHECK(errors(*cue, Scene::poseAt(1)) == first);
      CHECK(elsewhere != first);
    }
  }
}

TEST_CASE("A cue tells a right pose from a wrong one", "[cues]")
{
  addCentroid();
  for (const vpCueKind &kind : vpCueKinds::all()) {
    DYNAMIC_SECTION(kind.name)
    {
      Scene scene;
      const auto cue = make(kind, scene);
      scene.follow(*cue);
      const vpCameraParameters cam = pointScenes::makeCamera();
      const double right = cue->agreement(Scene::poseAt(1), cam).value_or(0.);
      const double wrong = cue->agreement(moved(Scene::poseAt(1), 0, 0.02), cam).value_or(0.);
      CHECK(right > 0.3);
      CHECK(right > wrong + 0.2);
    }
  }
}

TEST_CASE("Where an image shows nothing a cue has no equation, and says why", "[cues]")
{
  addCentroid();
  for (const vpCueKind &kind : vpCueKinds::all()) {
    for (const unsigned char level : {static_cast<unsigned char>(0), static_cast<unsigned char>(128)}) {
      DYNAMIC_SECTION(kind.name << ", gray level " << static_cast<int>(level))
      {
        Scene scene;
        const auto cue = make(kind, scene);
        const vpCueFrame nothing = scene.plain(level);
        const vpModelView &view = scene.view(nothing, Scene::poseAt(0));
        cue->matchFine(nothing, view, 0);
        cue->cue().match(nothing, view);
        for (const double error : errors(*cue, Scene::poseAt(0))) {
          CHECK(std::isfinite(error)); // Colours look for the silhouette wherever it would be.
        }
        CHECK_FALSE(cue->missing().empty());
        const std::optional<double> agreement = cue->agreement(Scene::poseAt(0), pointScenes::makeCamera());
        CHECK((!agreement || std::isfinite(*agreement)));
      }
    }
  }
}

TEST_CASE("A view without control points is no error for a cue", "[cues]")
{
  addCentroid();
  for (const vpCueKind &kind : vpCueKinds::all()) {
    DYNAMIC_SECTION(kind.name)
    {
      Scene scene;
      const auto cue = make(kind, scene);
      const vpCueFrame image = scene.frame(0);
      const vpHomogeneousMatrix beside(5., 0., 0.5, 0., 0., 0.);
      const vpModelView &view = scene.view(image, beside);
      REQUIRE(view.points().empty());
      cue->cue().match(image, view);
      CHECK(errors(*cue, beside).empty());
      CHECK_FALSE(cue->missing().empty());
      scene.learn(*cue, beside);
    }
  }
}

TEST_CASE("A cue that forgot is as good as new", "[cues]")
{
  addCentroid();
  for (const vpCueKind &kind : vpCueKinds::all()) {
    DYNAMIC_SECTION(kind.name)
    {
      Scene scene;
      const auto cue = make(kind, scene);
      scene.follow(*cue, 3);
      cue->forget(scene.looks);
      scene.follow(*cue);
      Scene other;
      const auto fresh = make(kind, other);
      other.follow(*fresh);
      CHECK(errors(*cue, Scene::poseAt(1)) == errors(*fresh, Scene::poseAt(1)));
    }
  }
}

TEST_CASE("A cue goes back to what it knew", "[cues]")
{
  addCentroid();
  for (const vpCueKind &kind : vpCueKinds::all()) {
    DYNAMIC_SECTION(kind.name)
    {
      Scene scene;
      const auto cue = make(kind, scene);
      scene.follow(*cue);
      const vpCueReference known = cue->reference();
      if (!known) {
        continue; // It has nothing to go back to.
      }
      const std::vector<double> before = errors(*cue, Scene::poseAt(1));
      const vpCueFrame other = scene.plain(200); // What it learns here it has to forget.
      cue->cue().match(other, scene.view(other, Scene::poseAt(1)));
      scene.learn(*cue, Scene::poseAt(1));
      const auto matchAgain = [&] {
        const vpCueFrame image = scene.frame(1);
        cue->cue().match(image, scene.view(image, Scene::poseAt(0)));
        return errors(*cue, Scene::poseAt(1));
      };
      CHECK(matchAgain() != before);
      cue->recall(known);
      CHECK(matchAgain() == before);
    }
  }
}

TEST_CASE("Kinds of cues that cannot be are refused", "[cues]")
{
  addCentroid();
  const vpCueKind good = vpTrackedCentroid::kind();
  const std::size_t number = vpCueKinds::all().size();
  vpCueKind kind = good;
  CHECK_THROWS_AS(vpCueKinds::add(kind), vpException); // Taken.
  kind.type = 3 << 6;
  kind.name = "two bits";
  CHECK_THROWS_AS(vpCueKinds::add(kind), vpException);
  kind.type = 1 << 7;
  kind.name = "edge";
  CHECK_THROWS_AS(vpCueKinds::add(kind), vpException);
  kind.name = "";
  CHECK_THROWS_AS(vpCueKinds::add(kind), vpException);
  kind.name = "nothing";
  kind.make = nullptr;
  CHECK_THROWS_AS(vpCueKinds::add(kind), vpException);
  CHECK(vpCueKinds::all().size() == number);
}
