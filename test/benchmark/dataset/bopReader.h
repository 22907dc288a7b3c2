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
  and, as this project writes them too, obj_000001.obj in metres, which is preferred, and obj_000001.cao.

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
