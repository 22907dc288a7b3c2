// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseKalmanFilter_h
#define vpPoseKalmanFilter_h

#include <visp3/se3/vpPoseExponential.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_se3
  How vpPoseKalmanFilter takes the object to move. The defaults suit objects and cameras that are held by hand.

  Velocities wander: the deviation of a velocity that was known at time 0 is wander * sqrt(t) at time t. So the numbers
  hold for any frame rate.
*/
struct VISP_EXPORT vpPoseKalmanSettings
{
  double translationWander = 1.; //!< Of the translation's velocity, m/s per square root of a second, > 0.
  double rotationWander = 3.;    //!< Of the rotation's velocity, rad/s per square root of a second, > 0.
  double startTranslation = 0.5; //!< Deviation of the translation's velocity when nothing is known of it, m/s, > 0.
  double startRotation = 2.;     //!< Deviation of the rotation's velocity when nothing is known of it, rad/s, > 0.
  double longestGap = 1.;        //!< After more time than this the velocity is forgotten, seconds, > 0.
  bool smooth = true;            //!< True: pose() is the filtered pose. False: it is the pose that was observed last.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \class vpPoseKalmanFilter
  \ingroup group_se3
  \brief Kalman filter with constant velocity in se(3): smooths poses, and predicts the next one with its uncertainty
  ([P14] eq. 15-24).

  The velocity xi = [v, omega] is that of the object relative to the camera, expressed in the object's frame:
  cMo(t + dt) = cMo(t) exp(xi dt), v in m/s of the object's origin, omega in rad/s. Constant velocity is then any screw
  motion: a straight line, an object on a turntable wherever its frame's origin is, a camera that turns on the spot.
  [P14] eq. 15 writes the same motions with the velocity in the camera's frame, velocityInCamera(). What differs is the
  noise. A velocity that wanders about the camera's centre swings a far object across the image, so its noise would
  have to depend on the distance; about the object's own origin the same numbers serve at every distance.

  \sa \ref se3_kalman
*/
class VISP_EXPORT vpPoseKalmanFilter
{
public:
  //! A pose with its uncertainty.
  struct Estimate
  {
    vpHomogeneousMatrix cMo;
    vpPoseMatrix6 covariance = vpPoseMatrix6::Zero(); //!< Of alpha, where exp(alpha) cMo is the true pose: coordinates
                                                      //!< [v, omega] in the camera's frame, m^2, m rad, rad^2.
  };

  //! \throw vpException naming the setting that is out of range.
  explicit vpPoseKalmanFilter(const vpPoseKalmanSettings &settings = vpPoseKalmanSettings());

  //! The state stays. \throw vpException naming the setting that is out of range; the old ones then stay.
  void setSettings(const vpPoseKalmanSettings &settings);
  const vpPoseKalmanSettings &settings() const { return m_settings; }

  //! Forgets pose and velocity.
  void reset()
  {
    m_isStarted = false;
    m_velocity.setZero();
  }
  //! True once a pose was given since the beginning or the last reset().
  bool isStarted() const { return m_isStarted; }

  /*!
    \param dt Time since the last update(), seconds, >= 0. After more than vpPoseKalmanSettings::longestGap the object
    is expected where it was last, give or take what it can have moved in that time.
    \return The pose to expect. The state does not change.
    \throw vpException if \e dt is out of range, or no pose was given yet.
  */
  Estimate predict(double dt) const;

  /*!
    Learns from an observed pose. The first one starts the filter, with unknown velocity; so does one after a gap.

    \param cMo The pose that was observed.
    \param covariance Of its error alpha, where exp(alpha) cMo is the true pose: coordinates [v, omega] in the camera's
    frame, m^2, m rad and rad^2 ([P14] eq. 14). Positive definite.
    \param dt Time since the last update, seconds, >= 0; any number where the filter is not started.
    \throw vpException naming the value if one is not finite, \e dt is negative, or \e covariance is not symmetric or
    not positive definite. The state then stays.
  */
  void update(const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &covariance, double dt);

  //! \return What to take for the pose now, see vpPoseKalmanSettings::smooth. \throw vpException before update().
  const vpHomogeneousMatrix &pose() const;
  //! \return The filtered pose and its uncertainty, also where smooth is off. \throw vpException before update().
  Estimate filtered() const;

  //! \return The object's velocity in its own frame, m/s and rad/s; 0 before update().
  const vpPoseTangent &velocity() const { return m_velocity; }
  //! \return The same velocity in the camera's frame: cMo(t + dt) = exp(v dt) cMo(t), the state of [P14] eq. 15.
  vpPoseTangent velocityInCamera() const;
  //! \return The covariance of velocity(), (m/s)^2, m/s rad/s, (rad/s)^2.
  vpPoseMatrix6 velocityCovariance() const { return m_covariance.bottomRightCorner<6, 6>(); }

  /*!
    \return What the last update's pose and its prediction differed by, in coordinates of unit variance: white noise
    where the filter's settings are right. 0 where there was no prediction. The sum of squares has a mean of 6.
  */
  const vpPoseTangent &whiteInnovation() const { return m_innovation; }

private:
  using Matrix12 = Eigen::Matrix<double, 12, 12>;

  // The pose, in the object's frame, and the covariance of its error and the velocity's.
  struct State
  {
    vpHomogeneousMatrix cMo;
    vpPoseTangent velocity;
    Matrix12 covariance;
  };

  State propagate(double dt) const;
  void start(const vpHomogeneousMatrix &cMo, const vpPoseMatrix6 &covariance);
  void requireStarted(const char *function) const;

  vpPoseKalmanSettings m_settings;
  bool m_isStarted = false;
  vpHomogeneousMatrix m_cMo;
  vpHomogeneousMatrix m_observed;
  vpPoseTangent m_velocity = vpPoseTangent::Zero();
  vpPoseTangent m_innovation = vpPoseTangent::Zero();
  Matrix12 m_covariance = Matrix12::Zero(); // Of [alpha, xi]: cMo exp(alpha) is the true pose, velocity + xi the true
                                            // velocity.
};

END_VISP_NAMESPACE

#endif
