// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsRecorder_h
#define programsRecorder_h

#include "dataset/bopWriter.h"
#include "track/trackingLog.h"

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>
#include <visp3/model/vpTrackedModel.h>

#include <string>
#include <vector>

namespace programs {

/*!
  Records a run as a data set in BOP's layout: images, camera, the poses of the frames whose state was TRACKING, and the
  model. Images of a camera with distortion are undistorted, as BOP's cameras have none.
*/
class Recorder
{
public:
  //! \param modelFile A .cao is copied beside the mesh. \throw vpException naming what cannot be made.
  Recorder(const std::string &folder, const vpCameraParameters &cam, const vpTrackedModel &model,
           const std::string &modelFile);

  void add(const vpImage<vpRGBa> &I, const TrackedFrame &frame);
  //! Writes the poses, when the last image was added.
  void finish() const;

private:
  vpCameraParameters m_cam;
  BopSceneWriter m_writer;
  std::vector<BopFrame> m_frames;
};

} // namespace programs
#endif
