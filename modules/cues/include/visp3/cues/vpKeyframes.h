// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpKeyframes_h
#define vpKeyframes_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/cues/vpCueFrame.h>
#include <visp3/cues/vpImageRegion.h>
#include <visp3/se3/vpCompatibility.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

BEGIN_VISP_NAMESPACE

struct vpRenderedView;

//! \ingroup group_cues_memory
//! A pose that features of keyframes agree on.
struct vpKeyframePose
{
  vpHomogeneousMatrix cMo;
  unsigned int agreeing = 0; //!< Features that the pose puts where the image shows them.
  unsigned int matched = 0;  //!< Features of keyframes that look like one of the image.
};

/*!
  \ingroup group_cues_memory
  Views of a textured object that were trusted, and the pose in another image by what is seen again of them: after a
  jump, a turn in the image plane, or a loss.

  A keyframe holds up to 150 corners of the surface with their place on the object and their ORB descriptor (Rublee
  et al., ICCV 2011); there are up to 16 by default, of views that differ by some degrees. In an image, corners are
  matched by their descriptors, and poses are drawn from three matches at a time (P3P); those that most matches agree on
  are refined and returned. A flat part of a surface often allows two poses: both are returned.

  Nothing is kept of a surface without corners, and nothing is found on it. Same calls, same result. See \ref
  cues_memory.
*/
class VISP_EXPORT vpKeyframes
{
public:
  //! Where the object may be.
  struct Where
  {
    vpHomogeneousMatrix expected; //!< Of two poses that as many features agree on, the one nearer to this is first.
    double shift = HUGE_VAL;      //!< Largest distance of the object's centre from there, in diameters.
    double turn = M_PI;           //!< Largest turn from there, radians.
  };

  //! False where the library was built without OpenCV's features2d and calib3d modules: nothing is then learnt.
  static bool isAvailable();

  //! \param most Views that are kept, at least 1: the oldest one goes where there are more.
  explicit vpKeyframes(std::size_t most = 16);
  ~vpKeyframes();

  //! Forgets all views. \param centre Middle of the object, object frame, metres. \param diameter Its size, metres, >
  //! 0.
  void setObject(const Eigen::Vector3d &centre, double diameter);
  void reset();
  std::size_t size() const;

  //! True where no keyframe shows the object from nearly the same direction and distance.
  bool wants(const vpHomogeneousMatrix &cMo) const;
  /*!
    Makes a keyframe of an image that is known to show the object; the oldest one goes where there are too many.
    \param frame Image. \param cMo The object's pose in it, trusted. \param depth Of the object at that pose in the
    whole image.
  */
  void learn(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const vpRenderedView &depth);
  //! The same of an image in which something may hide a part of the object: nothing is found by it before confirm().
  void propose(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo, const vpRenderedView &depth);
  /*!
    To be called with each image of a trusted pose. Of what was proposed 4 calls ago those features are kept that the
    image shows where the pose has them: what hides a part of the object hardly moves as it does. A keyframe with fewer
    than 12 of them is forgotten.
    \param frame Image. \param cMo The object's pose in it, trusted.
  */
  void confirm(const vpCueFrame &frame, const vpHomogeneousMatrix &cMo);

  /*!
    Looks for the object.
    \param frame Image. \param region Where features are looked for.
    \param where Where the object may be.
    \return At most two poses, the likeliest first; none where fewer than 10 features agree.
  */
  std::vector<vpKeyframePose> find(const vpCueFrame &frame, const vpImageRegion &region, const Where &where);
  //! Number of the features matched by the last find() that agree with a pose, up to 6 pixels off.
  unsigned int agreeing(const vpHomogeneousMatrix &cMo) const;

private:
  class Impl;
  std::unique_ptr<Impl> m_impl;
};

END_VISP_NAMESPACE
#endif
