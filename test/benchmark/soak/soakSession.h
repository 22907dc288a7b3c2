// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchSoakSession_h
#define benchSoakSession_h

#include "soak/soakReport.h"

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/model/vpCpuRenderer.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>
#include <visp3/se3/vpPoseRandom.h>

#include <memory>
#include <string>
#include <vector>

namespace bench {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

//! A tracker, the images that it gets, and a user who changes everything on the way.
class SoakSession
{
public:
  explicit SoakSession(std::uint64_t seed);
  ~SoakSession();
  SoakSession(const SoakSession &) = delete;
  SoakSession &operator=(const SoakSession &) = delete;

  //! Perhaps a change, and a frame.
  void step();
  //! Since the last call.
  SoakCounts takeCounts();

private:
  void makeTracker();
  void change();
  void changeSettings();
  void startAnew();
  void loadOther();
  void saveAndLoad();
  void moveObject();
  vpImage<vpRGBa> draw();
  template <typename Call> void attempt(const Call &call);
  bool happens(double everySoManyFrames) { return m_random.uniform() * everySoManyFrames < 1.; }
  double between(double first, double last) { return first + (last - first) * m_random.uniform(); }

  vpPoseRandom m_random;
  std::string m_folder;
  std::vector<std::string> m_models;
  std::unique_ptr<vpMbMultiCueTracker> m_tracker;
  std::shared_ptr<const vpTrackedModel> m_drawn; //!< That the renderer is of.
  std::unique_ptr<vpCpuRenderer> m_renderer;
  vpRenderedView m_view;
  vpImage<bool> m_mask;
  vpHomogeneousMatrix m_cMo;
  std::vector<double> m_motion = std::vector<double>(6, 0.); //!< Per frame, metres and radians.
  int m_hidden = 0;                                          //!< Frames for which nothing is shown yet.
  SoakCounts m_counts;
};

} // namespace bench
#endif
