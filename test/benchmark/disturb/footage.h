// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchFootage_h
#define benchFootage_h

#include "disturb/disturbOptions.h"
#include "evaluate/benchTracker.h"

#include <visp3/model/vpTrackedModel.h>

namespace bench {

//! Images in memory, and where the object is in each.
struct Footage
{
  SequenceObject object;
  std::shared_ptr<const vpTrackedModel> model;
  vpCameraParameters cam;
  std::vector<BenchImage> images;
  std::vector<vpHomogeneousMatrix> truth; //!< Of each image.
  std::vector<bool> isSeen;               //!< The object is in the image, most of it, and its pose is known.
};

//! \throw vpException naming the file that is missing or broken.
Footage openFootage(const DisturbOptions &options);

} // namespace bench
#endif
