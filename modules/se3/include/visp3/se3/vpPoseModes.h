// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseModes_h
#define vpPoseModes_h

#include <visp3/se3/vpPoseExponential.h>

#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_se3
  One place where poses gather.
*/
struct VISP_EXPORT vpPoseMode
{
  double mass = 0.;        //!< Share of all weights, 0 to 1.
  vpHomogeneousMatrix cMo; //!< Weighted mean of its poses, see vpPoseMean.
  vpPoseMatrix6
      covariance;       //!< About cMo: of alpha, where cMo exp(alpha) are the poses; object's frame, m^2, m rad, rad^2.
  std::size_t peak = 0; //!< The pose where its poses are densest.
  std::size_t count = 0; //!< Number of its poses.
};

/*!
  \class vpPoseModes
  \ingroup group_se3
  \brief Splits weighted poses into modes: the mean of poses that gather in several places is a place where none is.

  Each pose climbs to the nearest one where the poses are denser, if there is one within the tolerance, and those that
  end at the same peak are one mode (quick shift: A. Vedaldi and S. Soatto, "Quick shift and kernel methods for mode
  seeking", ECCV 2008). Nothing is random, and the order of the poses matters for equal densities only.

  Time and memory grow with the square of the number of poses.

  \sa \ref se3_particles
*/
class VISP_EXPORT vpPoseModes
{
public:
  /*!
    \param translation, rotation How far apart poses of one mode may be: a pose joins another one whose origin is
    t metres and whose rotation is r radians away if (t / translation)^2 + (r / rotation)^2 < 1, with 4 sin(r / 4) for
    r, which is 1 % less at 1 rad. The density is that of Gaussians with half of these as deviations. \throw
    vpException::badValue if one is not finite or not above 0.
  */
  vpPoseModes(double translation, double rotation);

  /*!
    \param poses, weights The first of each; weights >= 0 of any scale. Poses of weight 0 belong to no mode.
    \param count Number of poses.
    \param leastMass Modes with a smaller share of the weights are left out, except the first; 0 to 1.
    \return The modes, the one of the largest mass first; at least one.
    \throw vpException::badValue if there is no weight above 0, or a weight is negative or not finite.
  */
  std::vector<vpPoseMode> find(const vpHomogeneousMatrix *poses, const double *weights, std::size_t count,
                               double leastMass = 0.);

  /*!
    \param cMo The pose about which the covariance is.
    \param poses, weights The first of each; weights >= 0 of any scale, not all 0. \param count Number of poses.
    \return The weighted mean of alpha alpha^T, where cMo exp(alpha) are the poses: object's frame, m^2, m rad, rad^2.
  */
  static vpPoseMatrix6 covariance(const vpHomogeneousMatrix &cMo, const vpHomogeneousMatrix *poses,
                                  const double *weights, std::size_t count);

private:
  double squaredDistance(std::size_t i, std::size_t j) const;
  void findDensities(const double *weights, std::size_t count);
  void climb(const double *weights, std::size_t count);
  vpPoseMode modeOf(std::size_t peak, const vpHomogeneousMatrix *poses, const double *weights, std::size_t count);

  double m_translation;
  double m_rotation;
  std::vector<Eigen::Quaterniond> m_rotations;
  std::vector<Eigen::Vector3d> m_translations;
  std::vector<double> m_squares; // Distances of all pairs.
  std::vector<double> m_densities;
  std::vector<std::size_t> m_peaks; // Of each pose.
  std::vector<double> m_masked;     // The weights of one mode's poses, 0 for the others.
};

END_VISP_NAMESPACE

#endif
