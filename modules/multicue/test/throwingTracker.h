// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef throwingTracker_h
#define throwingTracker_h

#include "plainScene.h"

#include <algorithm>
#include <array>
#include <exception>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

/*! \file throwingTracker.h Trackers of several kinds that follow an object until an exception leaves track(). */

BEGIN_VISP_NAMESPACE
namespace throwingTracker {
const int edge = vpMbMultiCueTracker::EDGE_TRACKER;
const int color = vpMbMultiCueTracker::COLOR_TRACKER;
using Triangles = std::vector<modelShapes::Triangle>;

//! Calls of vpMbTracker that a derived class may make its own, and that track() comes to in its middle.
enum class Place
{
  INIT,
  RESIDUES,
  WEIGHTS
};

//! Throws out of one of them.
class ThrowingTracker : public vpMbMultiCueTracker
{
public:
  //! \param call The first one is 0.
  void throwAt(Place place, int call)
  {
    m_place = place;
    m_left = call;
  }
  void throwNowhere() { m_left = -1; }

  //! What a user set but for motions(), as numbers.
  std::vector<double> settings() const
  {
    std::vector<double> all;
    const auto add = [&all](auto... numbers) { (all.push_back(static_cast<double>(numbers)), ...); };
    const vpEdgeCueSettings edges = getEdgeSettings();
    add(edges.range, edges.contrast, edges.mu1, edges.mu2, edges.maskSize, edges.candidates);
    const vpMe me = getMovingEdge();
    add(me.getRange(), me.getThreshold(), me.getMu1(), me.getMu2(), me.getMaskSize(), me.getSampleStep());
    const vpColorCueSettings colors = getColorSettings();
    add(colors.spacing, colors.lines, colors.length, colors.alpha, colors.regularisation, colors.contourDeviation,
        colors.histogramLength, colors.learningRate, colors.rows);
    all.insert(all.end(), colors.scales.begin(), colors.scales.end());
    all.insert(all.end(), colors.bands.begin(), colors.bands.end());
    const vpPoseHypothesisSettings hypotheses = getPoseHypothesisSettings();
    add(hypotheses.enabled, hypotheses.reach);
    add(getParticleSettings().enabled, getTrackerType(), getFrameDeadline(), getGoodMovingEdgesRatioThreshold());
    add(m_maxIter, m_lambda, m_initialMu, m_stopCriteriaEpsilon, computeCovariance);
    return all;
  }
  //! The motions that a user lets be estimated, as a matrix.
  std::vector<double> motions() const { return std::vector<double>(oJo.data, oJo.data + 36); }

protected:
  void computeVVSInit() override
  {
    pass(Place::INIT);
    vpMbMultiCueTracker::computeVVSInit();
  }
  void computeVVSInteractionMatrixAndResidu() override
  {
    pass(Place::RESIDUES);
    vpMbMultiCueTracker::computeVVSInteractionMatrixAndResidu();
  }
  void computeVVSWeights(vpRobust &robust, const vpColVector &error, vpColVector &w) override
  {
    pass(Place::WEIGHTS);
    vpMbMultiCueTracker::computeVVSWeights(robust, error, w);
  }

private:
  void pass(Place place)
  {
    if (place == m_place && m_left >= 0 && m_left-- == 0) {
      throw std::runtime_error("of a derived class");
    }
  }

  Place m_place = Place::INIT;
  int m_left = -1;
};

//! How a tracker is set, and what it follows.
struct Kind
{
  const char *name;
  bool isRound; // Nothing shows its turns: the tracker leaves them out of what is estimated.
  int type;
  bool isPredicted = false;
  bool hasHypotheses = false;
  bool hasParticles = false;
  bool searches = false;
};

inline std::ostream &operator<<(std::ostream &out, const Kind &kind)
{
  return out << kind.name;
}

inline const std::vector<Kind> kinds = {
    {"edges of a can", true, edge},
    {"edges with hypotheses", false, edge, false, true},
    {"edges with particles", false, edge, true, false, true},
    {"edges and colours of a can", true, edge | color},
    {"edges and colours, predicted", false, edge | color, true},
    {"edges and colours, with a search", false, edge | color, true, true, true, true}};

inline Triangles shape(const Kind &kind)
{
  return kind.isRound ? modelShapes::cylinderTriangles(0.04, 0.12, 32)
                      : modelShapes::boxTriangles(Eigen::Vector3d(0.12, 0.07, 0.05));
}

inline void prepare(vpMbMultiCueTracker &tracker, const Kind &kind)
{
  const std::string file = meshFiles::temporaryFile("throwing.stl");
  std::ofstream(file) << meshFiles::asciiStl(shape(kind));
  tracker.setTrackerType(kind.type);
  tracker.setCameraParameters(plainScene::camera());
  tracker.loadModel(file);
  vpEdgeCueSettings edges = tracker.getEdgeSettings();
  edges.range = 12.;
  tracker.setEdgeSettings(edges);
  tracker.setPrediction(kind.isPredicted);
  tracker.setPredictedRange(true);
  tracker.setSearch(kind.searches);
  vpPoseHypothesisSettings hypotheses = tracker.getPoseHypothesisSettings();
  hypotheses.enabled = kind.hasHypotheses;
  tracker.setPoseHypothesisSettings(hypotheses);
  vpParticleSettings particles = tracker.getParticleSettings();
  particles.enabled = kind.hasParticles;
  tracker.setParticleSettings(particles);
}

inline bool same(const vpHomogeneousMatrix &a, const vpHomogeneousMatrix &b)
{
  return std::equal(a.data, a.data + 16, b.data);
}

inline bool isRight(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &truth)
{
  const double shift = (cMo.getTranslationVector() - truth.getTranslationVector()).frobeniusNorm();
  return shift < 0.004 && plainScene::tilt(cMo, truth) < 2.;
}

//! The object's images, drawn once.
inline const vpImage<vpRGBa> &imageOf(const Kind &kind, std::size_t frame)
{
  static std::array<std::vector<vpImage<vpRGBa>>, 2> drawn;
  std::vector<vpImage<vpRGBa>> &images = drawn[kind.isRound ? 1 : 0];
  if (images.empty()) {
    plainScene scene(shape(kind));
    for (int i = 0; i < 12; ++i) {
      images.push_back(scene.draw(plainScene::poseAt(i)));
    }
  }
  return images.at(frame);
}

inline vpImage<vpRGBa> nothing()
{
  return vpImage<vpRGBa>(plainScene::height, plainScene::width, vpRGBa(50, 90, 70));
}

//! A tracker that has followed its object for some frames.
struct Followed
{
  explicit Followed(const Kind &which) : kind(which)
  {
    prepare(tracker, kind);
    tracker.initFromPose(imageOf(kind, 0), plainScene::poseAt(0));
    for (std::size_t i = 1; i <= last; ++i) {
      tracker.track(imageOf(kind, i));
    }
    REQUIRE(tracker.getTrackingState() == vpTrackingState::TRACKING);
  }

  bool throwsWith(const vpImage<vpRGBa> &I)
  {
    try {
      tracker.track(I);
    } catch (const std::exception &) {
      return true;
    }
    return false;
  }

  //! In the next frame. \return False where the place is passed less often.
  bool throws(Place place, int call)
  {
    const vpImage<vpRGBa> &I = imageOf(kind, last + 1);
    tracker.throwAt(place, call);
    const bool hasThrown = throwsWith(I);
    tracker.throwNowhere();
    return hasThrown;
  }

  //! \return True where the next frames are tracked as if nothing had been.
  bool goesOn()
  {
    for (std::size_t i = last + 1; i < last + 4; ++i) {
      const bool hasThrown = throwsWith(imageOf(kind, i));
      if (hasThrown || tracker.getTrackingState() != vpTrackingState::TRACKING ||
          !isRight(tracker.getPose(), plainScene::poseAt(static_cast<int>(i)))) {
        return false;
      }
    }
    return true;
  }

  static constexpr std::size_t last = 3;
  Kind kind;
  ThrowingTracker tracker;
};

//! What a tracker was before an exception.
struct Before
{
  explicit Before(const ThrowingTracker &tracker)
      : cMo(tracker.getPose()), settings(tracker.settings()), motions(tracker.motions())
  {
  }

  vpHomogeneousMatrix cMo;
  std::vector<double> settings;
  std::vector<double> motions;
};

//! What an exception left of it.
struct Outcome
{
  Outcome(const std::string &where, Followed &followed, const Before &before)
      : text(followed.kind.name + where), keepsSettings(followed.tracker.settings() == before.settings),
        keepsMotions(followed.tracker.motions() == before.motions),
        keepsPose(same(followed.tracker.getPose(), before.cMo)), goesOn(followed.goesOn())
  {
  }

  std::string text; //!< Of where it was thrown.
  bool keepsSettings;
  bool keepsMotions;
  bool keepsPose;
  bool goesOn;
};

} // namespace throwingTracker
END_VISP_NAMESPACE
#endif
