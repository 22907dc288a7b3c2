// SPDX-License-Identifier: GPL-2.0-or-later
#include "vpEglDisplays.h"

#include <visp3/core/vpException.h>

#include <EGL/eglext.h>

#include <algorithm>
#include <sstream>

BEGIN_VISP_NAMESPACE

namespace {
bool hasWord(const char *words, const std::string &word)
{
  std::istringstream stream(words ? words : "");
  for (std::string candidate; stream >> candidate;) {
    if (candidate == word) {
      return true;
    }
  }
  return false;
}

template <class Function> Function load(const char *name)
{
  const Function function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (!function) {
    throw vpException(vpException::fatalError, std::string("eglGetProcAddress has no ") + name);
  }
  return function;
}

EGLDisplay openPlatform(EGLenum platform, void *native)
{
  const auto getDisplay = load<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const EGLDisplay display = getDisplay(platform, native, nullptr);
  if (display == EGL_NO_DISPLAY) {
    vpThrowEgl("eglGetPlatformDisplayEXT");
  }
  return display;
}

std::vector<EGLDeviceEXT> listDevices()
{
  const auto queryDevices = load<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  EGLint count = 0;
  if (!queryDevices(0, nullptr, &count) || count <= 0) {
    return {};
  }
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (!queryDevices(count, devices.data(), &count)) {
    return {};
  }
  devices.resize(static_cast<std::size_t>(count));
  return devices;
}

void appendDevices(std::vector<vpEglDisplayChoice> &choices)
{
  std::vector<EGLDeviceEXT> devices = listDevices();
  const bool canAsk = vpHasEglExtension(EGL_NO_DISPLAY, "EGL_EXT_device_query");
  const auto queryString =
      canAsk ? load<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT") : PFNEGLQUERYDEVICESTRINGEXTPROC();
  const auto isHardware = [queryString](EGLDeviceEXT device) {
    return !queryString || !hasWord(queryString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
  };
  const auto software = std::stable_partition(devices.begin(), devices.end(), isHardware);
  for (auto device = devices.begin(); device != devices.end(); ++device) {
    const std::string kind = device < software ? "hardware" : "software";
    choices.push_back({"EGL device " + std::to_string(choices.size()) + " (" + kind + ")",
                       [native = *device] { return openPlatform(EGL_PLATFORM_DEVICE_EXT, native); }});
  }
}
} // namespace

bool vpHasEglExtension(EGLDisplay display, const std::string &name)
{
  return hasWord(eglQueryString(display, EGL_EXTENSIONS), name);
}

void vpThrowEgl(const std::string &call)
{
  std::ostringstream message;
  message << call << " failed with EGL error 0x" << std::hex << eglGetError();
  throw vpException(vpException::fatalError, message.str());
}

std::vector<vpEglDisplayChoice> vpListEglDisplays()
{
  const auto has = [](const char *name) { return vpHasEglExtension(EGL_NO_DISPLAY, name); };
  const bool enumerates = has("EGL_EXT_device_enumeration") || has("EGL_EXT_device_base");
  std::vector<vpEglDisplayChoice> choices;
  if (enumerates && has("EGL_EXT_platform_device")) {
    appendDevices(choices);
  }
  if (has("EGL_MESA_platform_surfaceless")) {
    choices.push_back({"Mesa's surfaceless platform",
                       [] { return openPlatform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY); }});
  }
  choices.push_back({"default display", [] {
                       const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
                       if (display == EGL_NO_DISPLAY) {
                         vpThrowEgl("eglGetDisplay");
                       }
                       return display;
                     }});
  return choices;
}

END_VISP_NAMESPACE
