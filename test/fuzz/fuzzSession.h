// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef fuzzSession_h
#define fuzzSession_h

/*!
  \file fuzzSession.h
  The bytes of an input choose a tracker's model, camera and settings, and then call after call. vpException is an
  answer; any other exception, a pose or a score that is not a number, or a call without end is a fault.
*/
#include "fuzzBytes.h"
#include "fuzzGeometry.h"
#include "fuzzImages.h"
#include "fuzzModels.h"

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace fuzz {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

inline void require(bool ok, const char *what)
{
  if (!ok) {
    std::cerr << "Fault: " << what << std::endl;
    std::abort();
  }
}

//! What of a tracker is called.
enum class Calls
{
  ALL,
  WITHOUT_SEARCH //!< A search makes 2562 views of the model, which takes a minute with the sanitizers.
};

//! A tracker, and what its calls need.
class Session
{
public:
  Session(Bytes &bytes, Calls calls) : m_bytes(bytes), m_searches(calls == Calls::ALL)
  {
    m_tracker.setFrameDeadline(0.);
    forbidSearch();
  }

  void setUp()
  {
    attempt([&] { m_tracker.loadModel(m_models.file(m_bytes.byte())); });
    attempt([&] { m_tracker.setCameraParameters(cameraOf(m_bytes)); });
    attempt([&] { changeCues(); });
    m_width = m_bytes.choice(8) == 7 ? m_bytes.choice(20) : 24 + m_bytes.choice(137);
    m_height = m_bytes.choice(8) == 7 ? m_bytes.choice(20) : 24 + m_bytes.choice(97);
    const vpHomogeneousMatrix cMo = poseOf(m_bytes);
    m_shown = cMo;
    attempt([&] { m_tracker.initFromPose(color(), cMo); });
  }

  void step()
  {
    switch (m_bytes.choice(24)) {
    case 0:
      attempt([&] { changeCues(); });
      break;
    case 1:
      attempt([&] { m_tracker.setCameraParameters(cameraOf(m_bytes)); });
      break;
    case 2:
      attempt([&] { m_tracker.initFromPose(gray(), poseOf(m_bytes)); });
      break;
    case 3:
      attempt([&] { m_tracker.setPose(color(), poseOf(m_bytes)); });
      break;
    case 4:
      if (m_searches) {
        attempt([&] { m_tracker.initFromRoughPose(color(), poseOf(m_bytes)); });
      }
      break;
    case 5:
      attempt([&] { m_tracker.setPoseHint(poseOf(m_bytes)); });
      break;
    case 6:
      attempt([&] { m_tracker.reInitModel(color(), m_models.file(m_bytes.byte()), poseOf(m_bytes)); });
      break;
    case 7:
      attempt([&] { setMask(); });
      break;
    case 8:
      attempt([&] { changeSettings(); });
      break;
    case 9:
      attempt([&] { changeEdges(); });
      break;
    case 10:
      attempt([&] { checkScore(); });
      break;
    case 11:
      attempt([&] { askForMore(); });
      break;
    case 12:
      resize();
      break;
    case 13:
      m_shown = poseOf(m_bytes);
      break;
    case 14:
      attempt([&] { m_tracker.track(gray()); });
      break;
    default:
      sway();
      attempt([&] { m_tracker.track(color()); });
    }
  }

private:
  // What a call leaves behind has to be sound, whether it threw or not.
  template <typename Call> void attempt(const Call &call)
  {
    try {
      call();
    } catch (const vpException &) { // Refused by name.
    }
    const vpMbTrackingResult result = m_tracker.getTrackingResult();
    require(std::all_of(result.cMo.data, result.cMo.data + 16, [](double x) { return std::isfinite(x); }),
            "the pose is not finite");
    require(result.score >= 0. && result.score <= 1., "the score is no probability");
    require(!result.text.empty(), "no reason is told");
  }

  void changeCues()
  {
    const unsigned int choice = m_bytes.choice(12);
    if (choice < 5) {
      m_tracker.setPreset(static_cast<vpMultiCuePreset>(choice));
      m_tracker.setFrameDeadline(0.); // Else the same bytes do not do the same.
    } else {
      m_tracker.setTrackerType(static_cast<int>(m_bytes.choice(20)));
    }
    forbidSearch();
  }

  void forbidSearch()
  {
    if (!m_searches) {
      m_tracker.setSearch(false);
    }
  }

  void changeSettings()
  {
    const bool flag = m_bytes.flag();
    switch (m_bytes.choice(14)) {
    case 0:
      return m_tracker.setSearch(flag && m_searches);
    case 1:
      return m_tracker.setPrediction(flag);
    case 2:
      return m_tracker.setPredictedRange(flag);
    case 3:
      return m_tracker.setFrameInterval(m_bytes.anyNumber(0., 1.));
    case 4:
      return m_tracker.setCovarianceComputation(flag);
    case 5:
      return m_tracker.setProjectionErrorComputation(flag);
    case 6:
      return m_tracker.setTextureEdges(flag);
    case 7:
      return m_tracker.setLod(flag);
    case 8:
      return m_tracker.setNearClippingDistance(m_bytes.anyNumber(0., 1.));
    case 9:
      return m_tracker.setFarClippingDistance(m_bytes.anyNumber(0., 2.));
    case 10:
      return m_tracker.setAngleAppear(m_bytes.anyNumber(0., 1.6));
    case 11:
      return m_tracker.setMaxIter(m_bytes.choice(60));
    case 12:
      return changeParticles();
    default:
      m_tracker.resetTracker();
    }
  }

  void changeParticles()
  {
    vpParticleSettings particles;
    particles.enabled = m_bytes.flag();
    particles.number = 10 + m_bytes.choice(60);
    m_tracker.setParticleSettings(particles);
    vpPoseHypothesisSettings hypotheses;
    hypotheses.enabled = m_bytes.flag();
    m_tracker.setPoseHypothesisSettings(hypotheses);
  }

  void changeEdges()
  {
    vpEdgeCueSettings edges = m_tracker.getEdgeSettings();
    edges.range = m_bytes.anyNumber(1., 30.);
    edges.candidates = m_bytes.choice(8);
    m_tracker.setEdgeSettings(edges);
    vpMe me;
    me.setRange(m_bytes.choice(30));
    me.setSampleStep(m_bytes.anyNumber(0.5, 10.));
    me.setMaskSize(m_bytes.choice(12));
    m_tracker.setMovingEdge(me);
  }

  // The tracker keeps the mask where it is.
  void setMask()
  {
    m_mask.resize(m_bytes.choice(8) == 7 ? m_height + 1 : m_height, m_width);
    for (unsigned int i = 0; i < m_mask.getSize(); ++i) {
      m_mask.bitmap[i] = (i * m_bytes.choice(3)) % 7 != 1;
    }
    m_tracker.setMask(m_mask);
  }

  void checkScore()
  {
    const double score = m_tracker.score(color(), poseOf(m_bytes));
    require(score >= 0. && score <= 1., "the score of a pose is no probability");
  }

  void askForMore()
  {
    static_cast<void>(m_tracker.getFeaturesForDisplay());
    static_cast<void>(m_tracker.getError());
    static_cast<void>(m_tracker.getRobustWeights());
    static_cast<void>(m_tracker.getKltImagePointsWithId());
    attempt([&] { static_cast<void>(m_tracker.getCovarianceMatrix(1 << m_bytes.choice(6))); });
    static_cast<void>(vpMbTrackingResult::fromJson(m_tracker.getTrackingResult().toJson()));
    static_cast<void>(m_tracker.getModelForDisplay(m_width, m_height, poseOf(m_bytes), cameraOf(m_bytes)));
    static_cast<void>(m_tracker.computeCurrentProjectionError(gray(), poseOf(m_bytes), cameraOf(m_bytes)));
  }

  void resize()
  {
    m_width = m_bytes.choice(200);
    m_height = m_bytes.choice(200);
  }
  void sway()
  {
    const vpHomogeneousMatrix step(m_bytes.number(-0.01, 0.01), m_bytes.number(-0.01, 0.01), 0.,
                                   m_bytes.number(-0.1, 0.1), 0., m_bytes.number(-0.1, 0.1));
    m_shown = m_shown * step;
  }
  vpImage<vpRGBa> color() { return m_images.draw(m_bytes, m_width, m_height, m_shown, m_tracker); }
  vpImage<unsigned char> gray()
  {
    vpImage<unsigned char> I;
    vpImageConvert::convert(color(), I);
    return I;
  }

  Bytes &m_bytes;
  bool m_searches;
  Models m_models;
  Images m_images;
  vpImage<bool> m_mask;
  vpMbMultiCueTracker m_tracker;
  unsigned int m_width = 0;
  unsigned int m_height = 0;
  vpHomogeneousMatrix m_shown;
};

//! One input: a tracker is set up, and called as long as there are bytes.
inline int runSession(const std::uint8_t *data, std::size_t size, Calls calls)
{
  Bytes bytes(data, size);
  Session session(bytes, calls);
  session.setUp();
  const int mostSteps = 24;
  for (int i = 0; i < mostSteps && !bytes.isOver(); ++i) {
    session.step();
  }
  return 0;
}
} // namespace fuzz

#endif
