// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef settingsXml_h
#define settingsXml_h

#include <visp3/se3/vpCompatibility.h>

#include <string>

BEGIN_VISP_NAMESPACE
namespace vpSettingsDetail {
struct Draft;

//! Puts what an XML file says into \e draft. \throw vpException naming the file, and the line and node that is wrong.
void readXml(const std::string &file, Draft &draft);
} // namespace vpSettingsDetail
END_VISP_NAMESPACE
#endif
