// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchRecordedMotion_h
#define benchRecordedMotion_h

#include "generate/motion.h"

namespace bench {

/*!
  Poses of a file in RBOT's format (rbotReader.h), scale of them to a frame. Between two of them the velocity is
  constant.
*/
class RecordedMotion : public Motion
{
public:
  //! \throw vpException where the file cannot be read, has too few poses, or one puts the object into the camera.
  RecordedMotion(const SceneCamera &camera, const MotionSettings &settings);

  vpHomogeneousMatrix pose(double time) const override;

private:
  void fit(const SceneCamera &camera, const MotionSettings &settings, const MotionExtent &extent);

  std::vector<vpHomogeneousMatrix> m_poses;
  double m_scale;
};

} // namespace bench
#endif
