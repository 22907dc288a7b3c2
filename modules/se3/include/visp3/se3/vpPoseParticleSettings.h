// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseParticleSettings_h
#define vpPoseParticleSettings_h

#include <visp3/se3/vpPoseNoise.h>

#include <cstddef>
#include <cstdint>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_se3
  How vpPoseParticleFilter moves its particles and what it makes of optimised ones.
*/
struct VISP_EXPORT vpPoseParticleSettings
{
  //! Where the kernels of f, the density of the prediction, are.
  enum class Prior
  {
    PREDICTION, //!< Where the particles were before the noise: f is the very density that they were drawn from.
    PARTICLES   //!< At the particles, [T10] eq. 8: f is smoother and wider, by the noise once more.
  };

  std::size_t number = 100;       //!< Of particles that resample() keeps, > 0.
  double translationNoise = 0.01; //!< Deviation of each translation after noiseTime, metres, > 0.
  double rotationNoise = 0.03;    //!< Deviation of each rotation after noiseTime, radians, > 0.
  double noiseTime = 1. / 30.;    //!< The time step that the deviations are meant for, seconds, > 0.
  double noiseGrowth = 0.5;       //!< Deviations grow with the time step to this power, 0 to 1.5: 0.5 for a pose that
                                  //!< wanders, 1 for an unknown velocity, 0 for the same noise at each step.
  double jumpShare = 0.;  //!< Share of the particles with jumpFactor times these deviations, 0 to 0.9: a density with
                          //!< tails, so that an optimised pose far away has a chance.
  double jumpFactor = 4.; //!< See jumpShare, 1 to 100.
  vpPoseNoise::Frame noiseFrame = vpPoseNoise::Frame::OBJECT; //!< CAMERA is [T10] eq. 6.
  std::uint64_t seed = 1;                                     //!< The same seed and the same calls give the same bits.
  bool correctProposals = true;    //!< Weigh by f / g. False: as if optimised particles had been predicted.
  Prior prior = Prior::PREDICTION; //!< See above.
  bool scatterProposals = false; //!< True: draw the proposals from the kernels about the optimised poses, as importance
                                 //!< sampling asks for. False: take the optimised poses themselves, [T10].
  double proposalSpread = 1.;    //!< Deviations of the kernels about optimised poses, in units of the noise's, > 0.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

END_VISP_NAMESPACE

#endif
