// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/vpVrmlCheck.h"

#include "model/vpVrmlText.h"

#include <visp3/core/vpException.h>

#ifdef VISP_HAVE_COIN3D
#include "model/vpVrmlScene.h"

#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/VRMLnodes/SoVRMLGroup.h>
#include <Inventor/actions/SoToVRML2Action.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/nodes/SoSeparator.h>
#endif

BEGIN_VISP_NAMESPACE

#ifdef VISP_HAVE_COIN3D
namespace {
// Catches what Coin would print about the file.
class ReadErrors
{
public:
  ReadErrors() : m_callback(SoReadError::getHandlerCallback()), m_data(SoReadError::getHandlerData())
  {
    SoReadError::setHandlerCallback(&ReadErrors::take, this);
  }
  ~ReadErrors() { SoReadError::setHandlerCallback(m_callback, m_data); }
  ReadErrors(const ReadErrors &) = delete;
  ReadErrors &operator=(const ReadErrors &) = delete;

  const std::string &first() const { return m_first; }

private:
  static void take(const SoError *error, void *self)
  {
    std::string &first = static_cast<ReadErrors *>(self)->m_first;
    first = first.empty() ? error->getDebugString().getString() : first;
  }

  SoErrorCB *m_callback;
  void *m_data;
  std::string m_first;
};

// A reference that is given back.
template <typename Node> class Held
{
public:
  explicit Held(Node *node) : m_node(node)
  {
    if (m_node != nullptr) {
      m_node->ref();
    }
  }
  ~Held()
  {
    if (m_node != nullptr) {
      m_node->unref();
    }
  }
  Held(const Held &) = delete;
  Held &operator=(const Held &) = delete;
  Node *get() const { return m_node; }

private:
  Node *m_node;
};

[[noreturn]] void refuseUnread(const ReadErrors &errors)
{
  throw vpException(vpException::ioError,
                    "Coin cannot read it as VRML" + (errors.first().empty() ? std::string() : ": " + errors.first()));
}
} // namespace

std::vector<std::string> requireReadableVrml(const std::string &modelFile)
{
  requireHarmlessVrml(modelFile);
  SoDB::init();
  const ReadErrors errors;
  SoInput input;
  if (!input.openFile(modelFile.c_str())) {
    refuseUnread(errors);
  }
  if (input.isFileVRML2()) {
    const Held<SoVRMLGroup> scene(SoDB::readAllVRML(&input));
    if (scene.get() == nullptr || !errors.first().empty()) {
      refuseUnread(errors);
    }
    return requireWholeVrml2(*scene.get());
  }
  const Held<SoSeparator> scene(SoDB::readAll(&input));
  if (scene.get() == nullptr || !errors.first().empty()) {
    refuseUnread(errors);
  }
  requireWholeVrml1(*scene.get());
  SoToVRML2Action converter;
  converter.apply(scene.get());
  const Held<SoVRMLGroup> converted(converter.getVRML2SceneGraph());
  return requireWholeVrml2(*converted.get());
}
#else
std::vector<std::string> requireReadableVrml(const std::string &)
{
  throw vpException(vpException::notImplementedError,
                    "this ViSP was built without Coin, which reads .wrl files: use a .cao file or a mesh");
}
#endif

END_VISP_NAMESPACE
