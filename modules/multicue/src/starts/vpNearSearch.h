// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpNearSearch_h
#define vpNearSearch_h

#include "frame/vpSearchSize.h"
#include "starts/vpAttempts.h"

BEGIN_VISP_NAMESPACE

//! Starts around the pose that is expected, where that does not explain the image.
class vpNearSearch
{
public:
  vpNearSearch(const vpModelLooks &looks, const vpObjectMotion &motion, vpImageScore &score,
               const vpTrackerSymmetries &symmetries, const vpTrackerParticles &particles, vpAttempts &attempts)
      : m_looks(looks), m_motion(motion), m_score(score), m_symmetries(symmetries), m_particles(particles),
        m_attempts(attempts)
  {
  }

  //! The likeliest poses by the image's maps. \return True where one of them is enough.
  bool search(const vpFrameContext &frame);
  //! Turned a little about each axis, where nothing is searched for.
  void turn(const vpFrameContext &frame);

private:
  bool draw(const vpFrameContext &frame, std::size_t number, vpSearchSize &size, bool byColors);

  const vpModelLooks &m_looks;
  const vpObjectMotion &m_motion;
  vpImageScore &m_score;
  const vpTrackerSymmetries &m_symmetries;
  const vpTrackerParticles &m_particles;
  vpAttempts &m_attempts;
  vpSearchSize m_size;
  vpSearchSize m_sizeByScore;
};

END_VISP_NAMESPACE
#endif
