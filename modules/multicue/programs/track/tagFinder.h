// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsTagFinder_h
#define programsTagFinder_h

#include <visp3/multicue/vpWeightedPose.h>

#include <memory>
#include <vector>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! Tells the pose of an object by an AprilTag of the family 36h11 that is fixed to it.
class TagFinder
{
public:
  /*!
    \param id The tag's number. \param size Side of its black square, metres. \param oMt The tag's pose in the object's
    frame. \throw vpException where this ViSP was built without AprilTag.
  */
  TagFinder(int id, double size, const vpHomogeneousMatrix &oMt);
  ~TagFinder();

  //! \param cam Camera of the image. \return One pose of the object for each tag of that number.
  std::vector<vpWeightedPose> find(const vpImage<vpRGBa> &I, const vpCameraParameters &cam);

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace programs
#endif
