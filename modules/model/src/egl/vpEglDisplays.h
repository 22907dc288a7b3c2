// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEglDisplays_h
#define vpEglDisplays_h

#include <visp3/se3/vpCompatibility.h>

#include <EGL/egl.h>

#include <functional>
#include <string>
#include <vector>

BEGIN_VISP_NAMESPACE

//! A way to get a display, tried in the order of vpListEglDisplays().
struct vpEglDisplayChoice
{
  std::string name;                 //!< For messages.
  std::function<EGLDisplay()> open; //!< Throws vpException where there is none.
};

//! Devices with hardware, devices in software, Mesa's surfaceless platform, the default display.
std::vector<vpEglDisplayChoice> vpListEglDisplays();

//! \param display EGL_NO_DISPLAY asks for the extensions of the client library. \param name Whole name.
bool vpHasEglExtension(EGLDisplay display, const std::string &name);

//! \throw vpException with \e call and EGL's last error.
[[noreturn]] void vpThrowEgl(const std::string &call);

END_VISP_NAMESPACE
#endif
