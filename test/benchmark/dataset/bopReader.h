// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchBopReader_h
#define benchBopReader_h

#include "dataset/sequence.h"

namespace bench {

/*!
  Data sets in the layout of the BOP challenge (its toolkit's docs/bop_datasets_format.md).

  A scene is a folder with scene_camera.json, scene_gt.json, perhaps scene_gt_info.json, and images in rgb/ or gray/. It
  is the data set's folder itself (named "."), a folder in it, or one in a split of it ("test/000001"). The models are
  in models/ (or models_cad, models_eval, models_fine) of the data set, or of the scene: obj_000001.ply in millimetres,
  and, as this project writes them too, obj_000001.obj, which is preferred, in metres unless the
  diameter in models_info.json says millimetres, and obj_000001.cao.

  Scenes that several sensors saw have a file scene_camera_<sensor>.json (and scene_gt_<sensor>.json, and images in
  rgb_<sensor>/ or gray_<sensor>/) for each of them, and are as many scenes here: "test/000001@<sensor>".

  A frame whose image or camera cannot be read is left out, and a truth that cannot be, or in which the object is not in
  front of the camera, counts as none; Sequence::notes tell which. A scene with more than a tenth of such frames is
  refused.

  Lengths are millimetres there. BOP does not say where a pixel's centre is; it is taken to be at integers, as OpenCV's
  calibration has it.
*/
namespace bopReader {
//! Sorted; empty where there is no scene. \throw vpException naming the folder where it is missing.
std::vector<std::string> scenes(const std::string &dataset);

//! \param scene One of scenes(). \param object As for openSequence(). \throw vpException as openSequence().
Sequence open(const std::string &dataset, const std::string &scene, int object);
} // namespace bopReader

} // namespace bench
#endif
