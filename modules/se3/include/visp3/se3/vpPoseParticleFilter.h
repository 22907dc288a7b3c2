// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseParticleFilter_h
#define vpPoseParticleFilter_h

#include <visp3/se3/vpPoseMixture.h>
#include <visp3/se3/vpPoseModes.h>
#include <visp3/se3/vpPoseParticleSettings.h>

#include <cstdint>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \class vpPoseParticleFilter
  \ingroup group_se3
  \brief Particle filter on poses, guided by optimised particles: [T10] section III without images and models.

  The caller measures likelihoods, with any number of threads, and optimises poses. One frame:

  1. predict(): all particles move and get noise.
  2. weigh() with the logarithm of each particle's likelihood.
  3. Optionally propose() optimised poses, and weighProposals() with the logarithms of their likelihoods: the union of
     both sets, its weights corrected by f / g ([T10] eq. 8-9).
  4. modes(), mean(), covariance().
  5. resample().

  Steps 2 to 4 may be left out in any frame, and 5 where effectiveSize() is still large: particles keep their weights
  then. Numbers of particles may change from frame to frame.

  The steps allocate nothing once they have seen their largest numbers of particles, other than the poses that they
  return.

  \sa \ref se3_particles
*/
class VISP_EXPORT vpPoseParticleFilter
{
public:
  //! \throw vpException naming the setting that is out of range.
  explicit vpPoseParticleFilter(const vpPoseParticleSettings &settings = vpPoseParticleSettings());

  //! The particles stay; another number holds from the next resample(). \throw vpException naming the setting that is
  //! out of range; the old ones then stay.
  void setSettings(const vpPoseParticleSettings &settings);
  const vpPoseParticleSettings &settings() const { return m_settings; }

  /*!
    Starts with particles of equal weights about a pose.
    \param cMo The pose. \param noise Of the particles about it.
    \throw vpException::badValue if the pose is not finite.
  */
  void start(const vpHomogeneousMatrix &cMo, const vpPoseNoise &noise);
  /*!
    The same about several poses; each gets its share of the particles, rounded down or up.
    \param poses At least one. \param weights One for each, >= 0, not all 0. \param noise About each of them.
    \throw vpException::badValue if the sizes differ, or a value is out of range.
  */
  void start(const std::vector<vpHomogeneousMatrix> &poses, const std::vector<double> &weights,
             const vpPoseNoise &noise);
  //! Drops all particles.
  void reset() { m_size = m_predicted = 0; }
  bool isStarted() const { return m_size > 0; }

  /*!
    Moves the particles: cMo becomes cMo oMp exp(noise) or exp(noise) cMo oMp, with the deviations that the settings
    give for the time step (never less than a thousandth of those for noiseTime, so that f / g exists).

    \param dt Time since the last predict() or start(), seconds, >= 0.
    \param oMp How the object is expected to move in that time, in its own frame: exp(velocity dt) with the velocity of
    vpPoseKalmanFilter.
    \throw vpException if \e dt or \e oMp is not finite or out of range, the filter is not started, or proposals were
    not resampled.
  */
  void predict(double dt, const vpHomogeneousMatrix &oMp);
  //! The same where nothing is known of the motion.
  void predict(double dt);

  /*!
    Multiplies the weights by likelihoods. A second call in a frame replaces the first one.

    \param logLikelihoods One for each particle, of any common offset. -infinity, +infinity and NaN count as impossible;
    where all particles are, the weights stay as they were predicted.
    \return The logarithm of the mean likelihood, which tells how well the prediction fits; -infinity where all vanish.
    \throw vpException::badValue if there is not one number for each predicted particle.
  */
  double weigh(const std::vector<double> &logLikelihoods);

  /*!
    Adds a particle for each optimised pose, with the weight 0 until weighProposals(). Particle i of the predicted ones
    stays at i, the proposals follow them.

    \param optimised Poses that some optimisation has led to, such as those of the heaviest particles; may be empty.
    \throw vpException if weigh() was not called in this frame, propose() was, or a pose is not finite.
  */
  void propose(const std::vector<vpHomogeneousMatrix> &optimised);

  /*!
    Weighs all particles, predicted and proposed, by likelihood times f / g.

    \param logLikelihoods One for each proposal, with the offset of those given to weigh(). See there for numbers that
    are not finite.
    \return The logarithm of the mean likelihood of the prediction, with the proposals' part.
    \throw vpException if there is not one number for each proposal.
  */
  double weighProposals(const std::vector<double> &logLikelihoods);

  /*!
    Systematic resampling to the settings' number of particles of equal weights.
    \throw vpException if the filter is not started.
  */
  void resample();

  //! Sets the number of particles, and resamples where it is another one. \throw vpException if it is 0.
  void setNumber(std::size_t number);

  //! \return The number of particles now: those predicted, and the proposals before resample().
  std::size_t size() const { return m_size; }
  //! \return The number of particles before the proposals.
  std::size_t predictedSize() const { return m_predicted; }
  //! \return Particle \e i < size(); valid until the next step.
  const vpHomogeneousMatrix &pose(std::size_t i) const { return m_poses[i]; }
  //! \return A weight for each particle, their sum is 1.
  const std::vector<double> &weights() const { return m_weights; }
  //! \return How many equal weights have as much variance, see vpPoseResampling::effectiveSize().
  double effectiveSize() const;

  //! \return Mean of all particles ([T10] III-B2): no pose of the object where there are several modes.
  //! \throw vpException if the filter is not started.
  vpHomogeneousMatrix mean() const;
  //! \return Covariance about mean() of alpha, where mean() exp(alpha) are the particles: m^2, m rad, rad^2.
  vpPoseMatrix6 covariance() const;
  /*!
    \param finder Says how far apart particles of one mode may be.
    \param leastMass Modes of a smaller share are left out, except the first.
    \return The modes, the heaviest one first. Its mean is what to take for the object's pose.
    \throw vpException if the filter is not started.
  */
  std::vector<vpPoseMode> modes(vpPoseModes &finder, double leastMass = 0.01) const;

  //! \return What the mixtures of the last weighProposals() took.
  const vpPoseMixture::Effort &effort() const { return m_effort; }

private:
  void requireStarted(const char *function) const;
  void predict(double dt, const Eigen::Isometry3d &oMp);
  void reserve(std::size_t count);
  void scatter(std::size_t i, const Eigen::Isometry3d &cMo, const vpPoseNoise &noise);
  vpPoseNoise noiseOf(double dt, double factor) const;
  void clearPrior();
  void makeMixtures();
  void addPrior(const Eigen::Isometry3d &mean, double weight);
  double logPrior(const vpHomogeneousMatrix &cMo);
  double logCorrection(std::size_t i);
  void equaliseWeights();

  vpPoseParticleSettings m_settings;
  std::vector<vpHomogeneousMatrix> m_poses; // The first m_size are particles, those behind them spare.
  std::vector<vpHomogeneousMatrix> m_spare; // Where the next set is written.
  std::size_t m_size = 0;
  std::size_t m_predicted = 0;
  std::vector<double> m_weights;
  std::vector<double> m_priorWeights;   // Of the predicted particles, before their likelihoods.
  std::vector<double> m_logLikelihoods; // Of all particles.
  std::vector<double> m_logWeights;
  std::vector<std::size_t> m_picks;
  std::uint64_t m_step = 0; // Names the random numbers.
  bool m_isWeighed = false;
  bool m_isProposed = false;
  vpPoseNoise m_noise;       // Of the last prediction,
  vpPoseNoise m_jumpNoise;   // and of those particles that jump.
  vpPoseMixture m_prior;     // f without jumps.
  vpPoseMixture m_jumps;     // The part of f that they make.
  vpPoseMixture m_proposals; // g without its share of f
  vpPoseMixture::Effort m_effort;
};

END_VISP_NAMESPACE

#endif
