// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpOneCameraEntry_h
#define vpOneCameraEntry_h

#include <visp3/core/vpException.h>
#include <visp3/multicue/vpMbOneCamera.h>

// The entry of a map with one camera: members of vpMbOneCamera that its sources share.

BEGIN_VISP_NAMESPACE

namespace vpOneCameraEntry {
template <typename T> std::string keysOf(const std::map<std::string, T> &values)
{
  std::string keys;
  for (const auto &value : values) {
    keys += (keys.empty() ? "'" : ", '") + value.first + "'";
  }
  return keys.empty() ? "none" : keys;
}
} // namespace vpOneCameraEntry

template <typename T> const T &vpMbOneCamera::only(const PerCamera<T> &values) const
{
  const auto found = values.find(m_referenceCameraName);
  if (values.size() != 1 || found == values.end()) {
    throw vpException(vpException::badValue,
                      "Values were given for the cameras %s: this tracker has the camera '%s' alone, use "
                      "vpMbGenericTracker for several",
                      vpOneCameraEntry::keysOf(values).c_str(), m_referenceCameraName.c_str());
  }
  return found->second;
}

template <typename Pixel>
const vpImage<Pixel> &vpMbOneCamera::only(const PerCamera<const vpImage<Pixel> *> &images) const
{
  const vpImage<Pixel> *image = only<const vpImage<Pixel> *>(images);
  if (image == nullptr) {
    throw vpException(vpException::badValue, "The image of camera '%s' is a null pointer: give an image",
                      m_referenceCameraName.c_str());
  }
  return *image;
}

END_VISP_NAMESPACE
#endif
