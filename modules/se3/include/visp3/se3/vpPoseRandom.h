// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPoseRandom_h
#define vpPoseRandom_h

#include <visp3/se3/vpPoseExponential.h>

#include <array>
#include <cstdint>
#include <initializer_list>

BEGIN_VISP_NAMESPACE

/*!
  \class vpPoseRandom
  \ingroup group_se3
  \brief Random numbers that are a function of names, not of the order of calls.

  A filter makes one stream for each particle of each frame, `vpPoseRandom random(seed, {frame, particle})`, so that the
  particles are the same with any number of threads. All decisions are taken on integers, without the mathematical
  functions of the C library, and so the numbers are the same to the last bit with every compiler and platform.

  The generator is xoshiro256++ (Blackman and Vigna), and a stream is no secret: not for cryptography.
*/
class VISP_EXPORT vpPoseRandom
{
public:
  /*!
    \param seed Seed of the whole run.
    \param names What this stream is for, such as {frame, particle}; any number of names, whose order matters.
  */
  explicit vpPoseRandom(std::uint64_t seed, std::initializer_list<std::uint64_t> names = {});

  //! \return A number of the uniform distribution on [0, 1), a multiple of 2^-53.
  double uniform();

  //! \return A number of the standard normal distribution.
  double normal();

  //! \return Six independent numbers of the standard normal distribution.
  vpPoseTangent normalTangent();

  /*!
    \param count Number of choices, > 0.
    \return One of 0, ..., count - 1, all with the same probability to within count / 2^64.
    \throw vpException::badValue if \e count is 0.
  */
  std::uint64_t index(std::uint64_t count);

private:
  std::uint64_t bits();
  bool isHeadsOfExpHalf();
  bool isHeadsOfExpOverlap(unsigned int k, std::uint64_t fraction);
  bool isHeadsOfRatio(unsigned int k, std::uint64_t fraction);

  std::array<std::uint64_t, 4> m_state; //!< Never all zero.
};

END_VISP_NAMESPACE

#endif
