// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseNoise_h
#define vpPoseNoise_h

#include <visp3/se3/vpPoseExponential.h>
#include <visp3/se3/vpPoseRandom.h>

BEGIN_VISP_NAMESPACE

/*!
  \class vpPoseNoise
  \ingroup group_se3
  \brief Gaussian noise of a pose: zero mean and a 6x6 covariance on the exponential coordinates.

  It is meant for noise that is small against half a turn. Rotations beyond half a turn are drawn as they come, but
  logDensity() knows a pose by its shortest rotation only. Of isotropic rotations with deviations of 0.5, 0.75 and 1
  rad, shares of 1e-8, 5e-4 and 2e-2 are beyond half a turn.

  \sa \ref se3_noise
*/
class VISP_EXPORT vpPoseNoise
{
public:
  //! The frame in which the noise moves the object.
  enum class Frame
  {
    OBJECT, //!< cMo exp(alpha): the object moves about its own origin, metres and radians of the object.
    CAMERA  //!< exp(alpha) cMo, [T10] eq. 6: a rotation swings the object about the camera.
  };

  /*!
    \param covariance Of the coordinates alpha = [v, omega], in m^2, m rad and rad^2. It has to be positive definite, so
    that a density exists: give a degree of freedom that shall not move a small deviation instead of 0.
    \param frame The frame of alpha.
    \throw vpException::badValue if \e covariance has a value that is not finite, is not symmetric (to 1e-9 of the
    deviations' product) or is not positive definite (a coordinate that is known from the others to 1e-6 of its
    deviation counts as singular).
  */
  explicit vpPoseNoise(const vpPoseMatrix6 &covariance, Frame frame = Frame::OBJECT);

  /*!
    Independent noise on the six coordinates.

    \param translation Standard deviation of each translation, metres, > 0.
    \param rotation Standard deviation of each rotation, radians, > 0.
    \param frame The frame of the noise.
    \throw vpException::badValue if a deviation is out of range.
  */
  static vpPoseNoise isotropic(double translation, double rotation, Frame frame = Frame::OBJECT);

  /*!
    \param cMo Where the noise is centred.
    \param random Source of the random numbers: six normal numbers are taken from it.
    \return A pose of the distribution.
  */
  vpHomogeneousMatrix draw(const vpHomogeneousMatrix &cMo, vpPoseRandom &random) const;

  //! The same for a pose of Eigen's, without memory to allocate; equal up to rounding.
  Eigen::Isometry3d draw(const Eigen::Isometry3d &cMo, vpPoseRandom &random) const;

  /*!
    The density with respect to the invariant measure of SE(3), 1 / (m^3 rad^3), the same measure for both frames and
    every mean: sums and ratios of densities with different means are correct. At the mean it is that of a 6-dimensional
    Gaussian, (2 pi)^-3 |covariance|^-1/2.

    \param cMo Where the density is asked for.
    \param mean Where the noise is centred, an object-to-camera pose as well.
    \return The natural logarithm of the density.
  */
  double logDensity(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix &mean) const;

  //! \return The covariance that was given.
  const vpPoseMatrix6 &covariance() const { return m_covariance; }

  //! \return The lower triangular root of the covariance: the root times its transpose.
  const vpPoseMatrix6 &root() const { return m_root; }

  //! \return The logarithm of the density at the mean.
  double logPeak() const { return m_logPeak; }

  //! \return The frame of the noise.
  Frame frame() const { return m_frame; }

private:
  vpPoseMatrix6 m_covariance;
  vpPoseMatrix6 m_root; //!< Lower triangular, root times its transpose is the covariance.
  double m_logPeak;     //!< The logarithm of the density at the mean.
  Frame m_frame;
};

END_VISP_NAMESPACE

#endif
