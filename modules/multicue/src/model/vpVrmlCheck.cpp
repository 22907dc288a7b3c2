// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpVrmlCheck.h"

#include <visp3/core/vpException.h>

#ifdef VISP_HAVE_COIN3D
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/VRMLnodes/SoVRMLGroup.h>
#include <Inventor/nodes/SoSeparator.h>
#endif

BEGIN_VISP_NAMESPACE

#ifdef VISP_HAVE_COIN3D
void requireReadableVrml(const std::string &modelFile)
{
  SoDB::init();
  SoInput input;
  SoNode *scene = nullptr;
  if (input.openFile(modelFile.c_str())) {
    if (input.isFileVRML2()) {
      scene = SoDB::readAllVRML(&input);
    } else {
      scene = SoDB::readAll(&input);
    }
  }
  if (scene == nullptr) {
    throw vpException(vpException::ioError, "it is no VRML file");
  }
  scene->ref();
  scene->unref();
}
#else
void requireReadableVrml(const std::string &)
{
  throw vpException(vpException::notImplementedError,
                    "this ViSP was built without Coin, which reads .wrl files: use a .cao file or a mesh");
}
#endif

END_VISP_NAMESPACE
