// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTrackerImpl_h
#define vpTrackerImpl_h

#include "engine/vpMultiCueEngine.h"
#include "facade/vpAnyPoseScore.h"
#include "facade/vpMbTrackerNames.h"
#include "facade/vpPresetChoice.h"

#include <visp3/cues/vpFrameSource.h>
#include <visp3/multicue/vpMbMultiCueTracker.h>

#include <set>

BEGIN_VISP_NAMESPACE

//! Everything behind vpMbMultiCueTracker that vpMbTracker does not hold. What vpMbTracker holds itself (camera, angles,
//! clipping, level of detail, the estimation's settings) is not repeated: it is handed to the engine before it is
//! asked.
class vpMbMultiCueTracker::Impl
{
public:
  explicit Impl(vpMbMultiCueTracker &tracker);

  /** @name Settings */
  //@{
  //! Hands the engine what vpMbTracker holds.
  void handOver();
  //! Lets getMovingEdge() say what the edge cue does.
  void updateMe();
  vpMultiCueSettings settings();
  void apply(const vpMultiCueSettings &settings);
  void applySymmetries(const vpMultiCueSettings &settings);
  //! Loads a file, and the model that it says where there is none; all stays as it was where that throws.
  void load(const std::string &configFile, bool verbose);
  //! Takes over the settings that vpMultiCueSettings has not.
  void take(const Impl &before);
  //! The default constructor's preset, which nobody asked for.
  void assumePreset();
  void updatePointFilter();
  //@}

  /** @name Model */
  //@{
  vpTrackedModelBuilder collect(const vpTrackedModelBuilder &before, const std::string &modelFile,
                                const vpHomogeneousMatrix &odTo) const;
  void takeModel(vpTrackedModelBuilder &&added, vpTrackedModel &&loaded, const std::string &modelFile, bool verbose,
                 const vpHomogeneousMatrix &odTo);
  template <typename Pixel>
  void replaceModel(const vpImage<Pixel> &I, const std::string &modelFile, const vpHomogeneousMatrix &cMo, bool verbose,
                    const vpHomogeneousMatrix &odTo);
  void updateDetails();
  //@}

  /** @name Tracking */
  //@{
  //! \throw vpException where there is no model, or the image is empty.
  void requireTrackable(unsigned int width, unsigned int height) const;
  //! The same for a model that is not the tracker's yet, and where the object is not in view.
  void requireStart(unsigned int width, unsigned int height, const vpTrackedModel &model,
                    const vpHomogeneousMatrix &cMo) const;
  //! \return False, and the object is LOST, where the pose is one that no image of this size shows.
  bool isFollowable(const vpHomogeneousMatrix &cMo, unsigned int width, unsigned int height);
  template <typename Pixel> void setPoseOn(const vpImage<Pixel> &I, const vpHomogeneousMatrix &cdMo);
  void start(const vpHomogeneousMatrix &cMo, unsigned int width, unsigned int height);
  template <typename Pixel> void startOn(const vpImage<Pixel> &I);
  template <typename Pixel>
  bool startRoughlyOn(const vpImage<Pixel> &I, const std::vector<vpWeightedPose> &candidates,
                      const vpPoseDeviation &deviation);
  template <typename Pixel> bool startAnywhereOn(const vpImage<Pixel> &I, const vpDistanceRange &distances);
  template <typename Pixel> void trackOn(const vpImage<Pixel> &I);
  //@}

  /** @name Results */
  //@{
  template <typename Pixel> double scoreOn(const vpImage<Pixel> &I, const vpHomogeneousMatrix &cMo);
  //! Number of the rows that entered the pose.
  unsigned int nbFeatures(int type) const;
  //! \param cue Type of a cue.
  vpMbTrackingResult::Cue resultOf(int cue) const;
  //! The outcome as a sentence.
  std::string reasonText() const;
  void updateProjectionError(const vpCueFrame &image);
  //! A feature in the image as it was taken.
  struct Feature
  {
    vpImagePoint place;
    vpFeatureState state = vpFeatureState::GOOD;
    int id = -1; //!< Of a point; -1 for other features.
  };
  std::vector<Feature> featuresForDisplay() const;
  template <typename Pixel>
  void displayOn(const vpImage<Pixel> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                 const vpColor &col, unsigned int thickness, bool displayFullModel);
  template <typename Pixel>
  void displayHypothesesOn(const vpImage<Pixel> &I, const vpCameraParameters &cam, unsigned int thickness);
  template <typename Pixel>
  void displayParticlesOn(const vpImage<Pixel> &I, const vpCameraParameters &cam, unsigned int thickness);
  //@}

  vpMultiCueEngine &engine() { return m_engine; }
  const vpMultiCueEngine &engine() const { return m_engine; }

  // Settings.
  vpPresetChoice choice;
  vpMe me; // As the user gave it, for getMovingEdge().
  vpModelOptions modelOptions;
  std::string modelFile; // Of the model that a configuration file said.
  vpConfigReport report; // Of the last configuration file.
  bool throwOnLoss = false;
  bool displayHypotheses = false;
  //! Names of the model's faces that take no part.
  struct Untracked
  {
    std::set<std::string> edges;
    std::set<std::string> points;
  };
  Untracked untracked;

  std::unique_ptr<vpTrackedModelBuilder> parts; // What loadModel() added up to now.
  bool hasMesh = false;                         // One of the parts is a mesh.
  std::unique_ptr<vpModelView> displayView;
  vpFrameSource source;

private:
  //! vpMbTracker's steps of the estimation.
  class Servoing : public vpServoing
  {
  public:
    explicit Servoing(vpMbMultiCueTracker &tracker) : m_tracker(tracker) {}
    vpHomogeneousMatrix &pose() override { return m_tracker.m_cMo; }
    vpColVector &error() override { return m_tracker.m_error; }
    vpColVector &weights() override { return m_tracker.m_w; }
    vpMatrix &interaction() override { return m_tracker.m_L; }
    vpMatrix &chosenMotions() override { return m_tracker.oJo; }
    bool areAllChosen() const override { return m_tracker.m_isoJoIdentity; }
    unsigned int mostIterations() const override { return m_tracker.m_maxIter; }
    double convergence() const override { return m_tracker.m_stopCriteriaEpsilon; }
    double firstDamping() const override { return m_tracker.m_initialMu; }
    void init() override { m_tracker.computeVVSInit(); }
    void evaluate() override { m_tracker.computeVVSInteractionMatrixAndResidu(); }
    void weigh(vpRobust &robust, const vpColVector &error, vpColVector &w) override
    {
      m_tracker.computeVVSWeights(robust, error, w);
    }
    bool mustRestart(unsigned int iteration, Step &step) override;
    void solve(bool allMotions, unsigned int iteration, Step &step) override;

  private:
    vpMbMultiCueTracker &m_tracker;
  };

  void takeFromVisp(vpMultiCueSettings &settings) const;
  //! \param settings Checked ones.
  void giveToVisp(const vpMultiCueSettings &settings);
  //! Runs what estimates poses. The tracker's pose is scratch memory meanwhile; where something throws, it is the one
  //! before again, else the one that was found.
  template <typename Function> void estimate(const Function &function);

  vpMbMultiCueTracker &m_tracker;
  Servoing m_servoing;
  vpMultiCueEngine m_engine;
  bool m_filtersPoints = false; // By untracked faces.
  vpAnyPoseScore m_anyScore;
  vpFrameSource m_scoredImage;
};

template <typename Function> void vpMbMultiCueTracker::Impl::estimate(const Function &function)
{
  handOver();
  const vpHomogeneousMatrix before = m_tracker.m_cMo;
  vpHomogeneousMatrix cMo = before;
  try {
    function(cMo);
  } catch (...) {
    m_tracker.m_cMo = before;
    throw;
  }
  m_tracker.m_cMo = cMo;
}

END_VISP_NAMESPACE
#endif
