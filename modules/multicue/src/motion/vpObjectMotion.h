// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpObjectMotion_h
#define vpObjectMotion_h

#include "motion/vpInertia.h"

#include <visp3/model/vpTrackedModel.h>
#include <visp3/se3/vpPoseKalmanFilter.h>

#include <array>
#include <optional>
#include <vector>

BEGIN_VISP_NAMESPACE

class vpModelLooks;
class vpTrackerSymmetries;

//! How the object moves: where it was trusted to be, where it is expected, and how surprising another pose is.
class vpObjectMotion
{
public:
  //! A pose that was started from or tracked.
  struct Trusted
  {
    vpHomogeneousMatrix cMo;
    vpPoseTangent velocity = vpPoseTangent::Zero(); //!< Of the object in its own frame, 1 / s; 0 where it is unknown.
    double time = 0.;
  };

  //! A start, or another model: nothing is known of how the object moves.
  void forgetImages();
  //! Of how the object moves, nothing is known any more.
  void forget();
  //! How the object was when the frame before ended.
  struct Situation
  {
    bool isSearched = false; //!< It is looked for when it is lost: a prediction that is too old is of no use then.
    bool isLost = false;
    bool mustConfirm = false; //!< A pose that was found after a loss is no news to the filter before it is confirmed.
  };
  //! Begins a frame. \param cMo Pose of the frame before, and where the object is expected in this one.
  //! \param holdsTurns Nothing in the last image showed a turn about an axis of the object's shape.
  void predict(const Situation &situation, const vpModelLooks &looks, const vpTrackerSymmetries &symmetries,
               bool holdsTurns, vpHomogeneousMatrix &cMo);
  //! Where the object is expected in this frame.
  const vpHomogeneousMatrix &expected() const { return m_expected; }
  //! Something else than the filter tells it.
  void expect(const vpHomogeneousMatrix &cMo) { m_expected = cMo; }
  //! True where what the image does not show goes on as expected.
  bool holdsPrediction() const { return m_holdsPrediction; }
  //! How far edges have to be searched for, pixels; 0: not known. \param set By the user.
  double predictedRange(const vpModelLooks &looks, double set) const;
  //! True where the prediction is still better than the last pose, for an object that is not seen.
  bool mayCoast() const { return predicts && kalman.isStarted() && m_sinceUpdate < longestCoast; }

  //! How far a pose is off the expected one: distance of the object's middle in diameters, and angle in radians.
  std::array<double, 2> offExpected(const vpHomogeneousMatrix &cMo, const vpTrackedModel &model) const;
  //! The same squared, in the deviations that are usual.
  double surpriseAt(const vpHomogeneousMatrix &cMo, const vpTrackedModel &model) const;
  //! Logarithm of the odds of a pose beforehand, by how far it is off the expected one; 0 there. Its tail is heavy:
  //! hands and cameras jump.
  double oddsAt(const vpHomogeneousMatrix &cMo, const vpTrackedModel &model) const;
  //! At a pose that was less likely the object jumped.
  static constexpr double farOdds = -2.7;
  //! Mean squared distance from the expected poses, in diameters and radians.
  const std::array<double, 2> &surprise() const { return m_surprise; }
  //! From a trusted pose.
  void learnSurprise(const vpHomogeneousMatrix &cMo, const vpTrackedModel &model);
  //! After a loss, the object may be anywhere.
  void expectJumps();
  //! \param covariance Of the pose's error, camera frame; with doubt of a pose that is not trusted.
  void update(const vpHomogeneousMatrix &cMo, vpPoseMatrix6 covariance, double doubt, double diameter);
  //! After a trusted frame.
  void updateInertia(const vpHomogeneousMatrix &cMo);

  void trust(const vpHomogeneousMatrix &cMo, const vpPoseTangent &velocity = vpPoseTangent::Zero());
  //! Where the object is if it went on as it moved when it was trusted. \param share Of the way that it would have
  //! gone.
  vpHomogeneousMatrix movedOn(const Trusted &from, double share, const Eigen::Vector3d &centre) const;
  //! Where the object was trusted to be, where it is if it went on as it moved then, and halfway.
  std::array<vpHomogeneousMatrix, 3> whereaboutsOf(const Trusted &from, const Eigen::Vector3d &centre) const;

  // Settings.
  bool predicts = false; //!< With the Kalman filter.
  bool rangeIsPredicted = false;
  double frameInterval = 1. / 30.; //!< Seconds.
  vpPoseKalmanFilter kalman;

  vpInertia inertia;
  double time = 0.; //!< Of all frames since the tracker was made, seconds.
  Trusted trusted;  //!< The last one.
  //! The one that older knowledge is of, while what was trusted since may be something else.
  std::optional<Trusted> trustedBefore;

private:
  static constexpr double longestCoast = 0.5; // Seconds.

  double m_sinceUpdate = 0.; // Of the filter, seconds.
  vpHomogeneousMatrix m_expected;
  vpPoseMatrix6 m_expectedCovariance = vpPoseMatrix6::Zero();
  vpHomogeneousMatrix m_predicted;
  bool m_isPredicted = false;
  bool m_holdsPrediction = false;
  std::array<double, 2> m_surprise = {{0., 0.}};
};

END_VISP_NAMESPACE
#endif
