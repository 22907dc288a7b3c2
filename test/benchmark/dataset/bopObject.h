// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchBopObject_h
#define benchBopObject_h

#include "dataset/sequence.h"

#include <filesystem>

namespace bench {

/*!
  Finds an object's files, its diameter and its symmetries in a BOP data set.
  \param dataset, scene Folders in which the models' folder may be.
  \throw vpException naming the model that is missing, or the key of models_info.json that is broken.
*/
SequenceObject findBopObject(const std::filesystem::path &dataset, const std::filesystem::path &scene, int id);

} // namespace bench
#endif
