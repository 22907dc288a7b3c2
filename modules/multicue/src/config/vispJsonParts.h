// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vispJsonParts_h
#define vispJsonParts_h

#include "config/vispJsonCarrier.h"

#include <string>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
/** @name Objects that the files of several trackers of ViSP have
  place: JSON pointer of the object; nothing happens where it is missing. They throw a vpException, without the file's
  name, where the object is broken. */
//@{
//! A vpCameraParameters.
void takeCamera(const std::string &place, VispJsonCarrier &carrier);
//! A vpMe.
void takeEdges(const std::string &place, VispJsonCarrier &carrier);
//! A vpKltOpencv.
void takePoints(const std::string &place, VispJsonCarrier &carrier);
//@}
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
