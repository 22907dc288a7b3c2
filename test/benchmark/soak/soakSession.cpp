// SPDX-License-Identifier: GPL-2.0-or-later
#include "soak/soakSession.h"

#include <processorTime.h>

#include <visp3/core/vpException.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace bench {
namespace {
namespace fs = std::filesystem;
const unsigned int width = 160;
const unsigned int height = 120;

vpCameraParameters camera()
{
  return vpCameraParameters(200., 200., 79.5, 59.5);
}

//! A box, or two that touch, as a mesh. \param upper Has the second one.
std::string boxText(double x, double y, double z, bool upper)
{
  std::string text;
  int count = 0;
  const auto add = [&](double left, double right, double low, double high) {
    for (int i = 0; i < 8; ++i) {
      text += "v " + std::to_string(i & 1 ? right : left) + " " + std::to_string(0.5 * (i & 2 ? y : -y)) + " " +
              std::to_string(i & 4 ? high : low) + "\n";
    }
    for (const char *side : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"}) {
      text += "f";
      for (const char *c = side; *c != '\0'; c += 2) {
        text += " " + std::to_string(*c - '0' + count);
        if (c[1] == '\0') {
          break;
        }
      }
      text += "\n";
    }
    count += 8;
  };
  add(-0.5 * x, 0.5 * x, -0.5 * z, 0.5 * z);
  if (upper) {
    add(-0.5 * x, 0., 0.5 * z, 1.2 * z);
  }
  return text;
}
} // namespace

SoakSession::SoakSession(std::uint64_t seed)
    : m_random(seed),
      m_folder((fs::temp_directory_path() / ("multicue-soak-" + std::to_string(std::time(nullptr)))).string())
{
  fs::create_directories(m_folder);
  const auto write = [this](const std::string &name, const std::string &text) {
    m_models.push_back(m_folder + "/" + name);
    std::ofstream(m_models.back()) << text;
  };
  write("box.obj", boxText(0.12, 0.07, 0.05, false));
  write("step.obj", boxText(0.1, 0.08, 0.05, true));
  write("plate.cao", "V1\n4\n-.06 -.04 0\n.06 -.04 0\n.06 .04 0\n-.06 .04 0\n0\n0\n1\n4 0 1 2 3\n0\n0\n");
  makeTracker();
}

SoakSession::~SoakSession()
{
  std::error_code ignored;
  fs::remove_all(m_folder, ignored);
}

template <typename Call> void SoakSession::attempt(const Call &call)
{
  try {
    call();
  } catch (const vpException &) { // A pose beside the image for instance: the tracker goes on.
    ++m_counts.refused;
  }
}

void SoakSession::makeTracker()
{
  m_tracker = std::make_unique<vpMbMultiCueTracker>();
  m_tracker->setCameraParameters(camera());
  m_tracker->loadModel(m_models[m_random.index(m_models.size())]);
  ++m_counts.trackers;
  startAnew();
}

void SoakSession::startAnew()
{
  m_cMo = vpHomogeneousMatrix(between(-0.05, 0.05), between(-0.04, 0.04), between(0.3, 0.6), between(-1., 1.),
                              between(-1., 1.), between(-3., 3.));
  m_hidden = 0;
  const vpHomogeneousMatrix off(between(-0.005, 0.005), between(-0.005, 0.005), 0., between(-0.05, 0.05), 0., 0.);
  const vpImage<vpRGBa> I = draw();
  if (happens(4.)) {
    attempt([&] { m_tracker->initFromRoughPose(I, m_cMo * off); });
  } else {
    attempt([&] { m_tracker->initFromPose(I, m_cMo * off); });
  }
}

void SoakSession::loadOther()
{
  const std::string &file = m_models[m_random.index(m_models.size())];
  if (happens(2.)) {
    m_tracker->resetTracker();
    m_tracker->loadModel(file);
    startAnew();
  } else {
    attempt([&] { m_tracker->reInitModel(draw(), file, m_cMo); });
  }
}

void SoakSession::changeSettings()
{
  const bool flag = happens(2.);
  vpParticleSettings particles = m_tracker->getParticleSettings();
  switch (m_random.index(8)) {
  case 0:
    return m_tracker->setPreset(static_cast<vpMultiCuePreset>(m_random.index(5)));
  case 1:
    return m_tracker->setTrackerType(flag ? 1 : 19);
  case 2:
    return m_tracker->setSearch(flag);
  case 3:
    return m_tracker->setPrediction(flag);
  case 4:
    return m_tracker->setFrameDeadline(flag ? 33. : 0.);
  case 5:
    particles.enabled = flag;
    return m_tracker->setParticleSettings(particles);
  case 6:
    m_mask = vpImage<bool>(height, width, true);
    return m_tracker->setMask(m_mask);
  default:
    m_tracker->setCovarianceComputation(flag);
  }
}

void SoakSession::saveAndLoad()
{
  const std::string file = m_folder + "/settings.json";
  m_tracker->saveConfigFile(file);
  m_tracker->loadConfigFile(file, false);
  m_tracker->getTrackingResult().saveToFile(m_folder + "/result.json");
}

void SoakSession::change()
{
  if (happens(1500.)) {
    makeTracker();
  } else if (happens(700.)) {
    loadOther();
  } else if (happens(150.)) {
    startAnew();
  } else if (happens(100.)) {
    attempt([&] { changeSettings(); });
  } else if (happens(300.)) {
    attempt([&] { saveAndLoad(); });
  } else if (happens(80.)) {
    m_hidden = 1 + static_cast<int>(m_random.index(8));
  }
}

// Swings about the camera's axis, so that it leaves the image now and then and comes back.
void SoakSession::moveObject()
{
  for (std::size_t i = 0; i < 6; ++i) {
    m_motion[i] = 0.9 * m_motion[i] + (i < 3 ? 0.0006 : 0.008) * m_random.normal();
  }
  m_cMo = m_cMo * vpHomogeneousMatrix(0., 0., 0., m_motion[3], m_motion[4], m_motion[5]);
  const double middle[3] = {0., 0., 0.45};
  for (unsigned int i = 0; i < 3; ++i) {
    m_cMo[i][3] += m_motion[i] + 0.01 * (middle[i] - m_cMo[i][3]);
  }
}

vpImage<vpRGBa> SoakSession::draw()
{
  vpImage<vpRGBa> I(height, width, vpRGBa(50, 90, 70));
  if (m_tracker->getModel() != m_drawn) {
    m_drawn = m_tracker->getModel();
    m_renderer = std::make_unique<vpCpuRenderer>(m_drawn);
  }
  vpRenderOptions options;
  options.channels = vpRenderOptions::DEPTH | vpRenderOptions::NORMAL;
  m_renderer->render(m_cMo, camera(), width, height, options, m_view);
  for (int k = 0; k < m_view.width * m_view.height && m_hidden == 0; ++k) {
    const std::size_t at = static_cast<std::size_t>(k);
    if (m_view.depth[at] > 0.F) {
      const float slope = m_view.normal[at].z();
      const auto level = static_cast<unsigned char>(220.F - 110.F * slope * slope);
      I[static_cast<unsigned int>(m_view.top + k / m_view.width)]
       [static_cast<unsigned int>(m_view.left + k % m_view.width)] = vpRGBa(level, 70, 40);
    }
  }
  return I;
}

void SoakSession::step()
{
  change();
  moveObject();
  const vpImage<vpRGBa> I = draw();
  m_hidden -= m_hidden > 0 ? 1 : 0;
  const double start = processorTime();
  attempt([&] { m_tracker->track(I); });
  m_counts.seconds += processorTime() - start;
  ++m_counts.frames;
  m_counts.tracking += m_tracker->getTrackingResult().state == vpTrackingState::TRACKING ? 1 : 0;
}

SoakCounts SoakSession::takeCounts()
{
  const SoakCounts counts = m_counts;
  m_counts = SoakCounts();
  return counts;
}

} // namespace bench
