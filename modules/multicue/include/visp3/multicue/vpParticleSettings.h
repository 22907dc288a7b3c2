// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpParticleSettings_h
#define vpParticleSettings_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/se3/vpCompatibility.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_multicue
  The particle filter of vpMbMultiCueTracker ([T10] III): many poses at once, each weighed by the image, the best ones
  optimised. See \ref multicue_particles.

  Lengths are in diameters of the object, so that the defaults serve objects of any size.
*/
struct VISP_EXPORT vpParticleSettings
{
  //! The frame in which the noise moves the object.
  enum NoiseFrame
  {
    OBJECT, //!< That at the middle of the object's box: turns leave the object where it is.
    CAMERA  //!< [T10] eq. 6: turns swing the object about the camera.
  };
  //! Where particles move before the noise.
  enum Motion
  {
    RANDOM_WALK, //!< They stay, [T10] eq. 6.
    VELOCITY     //!< As vpPoseKalmanFilter takes the object to move.
  };
  //! The pose that the particles give.
  enum Output
  {
    MEAN,     //!< Weighted mean of all of them, [T10] III-B2: between the modes where there are several.
    BEST_MODE //!< The pose as without particles, or one that they led to where that explains the image better.
  };

  bool enabled = false;          //!< Off: none of the others matters.
  unsigned int number = 100;     //!< Of particles, [10, 10000].
  unsigned int leastNumber = 50; //!< With a budget: fewest particles, [10, 10000].
  unsigned int mostNumber = 300; //!< With a budget: most particles, at least leastNumber, [10, 10000].
  double budget = 0.; //!< Time of a frame that decides on the number of particles, milliseconds, [0, 1000]; 0:
                      //!< always \e number. Results then depend on the machine and on what else it does.
  double translationNoise = 0.015; //!< Least deviation of each translation after 1/30 s, diameters, (0, 1].
  double rotationNoise = 0.04;     //!< Least deviation of each rotation after 1/30 s, radians, (0, 1].
  double motionNoise = 1.5;        //!< Least deviation in units of how far the object was lately from where it was
                                   //!< expected, for each axis, [0, 10]; 0: the noise is always the same.
  double jumpShare = 0.4;          //!< Share of the particles whose noise is jumpFactor times as large, [0, 0.9].
  double jumpFactor = 4.;          //!< See jumpShare, [1, 100].
  NoiseFrame noiseFrame = OBJECT;  //!< Frame of the noise.
  Motion motion = RANDOM_WALK;     //!< How particles move.
  double lambda = 100.;           //!< Of the likelihood exp(-lambda ((d - dmin) / (dmax - dmin))^2), [T10] eq. 12, with
                                  //!< edges alone; [0, 1000].
  double sharpness = 40.;         //!< Of the likelihood exp(sharpness s) with several cues, [0, 1000]. Of s, which is
                                  //!< about 1 for a right pose and 0 by chance, see \ref multicue_particles.
  double bestShare = 0.01;        //!< Share of the best likelihood from which on particles are optimised, [0, 1].
  unsigned int mostOptimised = 8; //!< Most particles that are optimised in a frame, [0, 100]; beside them, the pose
                                  //!< before always is. While that explains the image no more than two are.
  Output output = BEST_MODE;      //!< The pose that they give.
  double modeTranslation = 0.06;  //!< How far apart particles of one mode may be, diameters, (0, 10].
  double modeRotation = 0.15;     //!< Likewise, radians, (0, 3].
  unsigned int seed = 1;          //!< The same seed gives the same poses.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_multicue
  One of the poses that vpMbMultiCueTracker::getParticles() returns.
*/
struct vpPoseParticle
{
  vpHomogeneousMatrix cMo;
  double weight = 0.; //!< Share of all weights; they add up to 1.
};

END_VISP_NAMESPACE
#endif
