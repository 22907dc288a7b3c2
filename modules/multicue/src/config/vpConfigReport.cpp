// SPDX-License-Identifier: GPL-2.0-or-later
#include <visp3/multicue/vpConfigReport.h>

#include <algorithm>
#include <ostream>

BEGIN_VISP_NAMESPACE

const char *toString(vpConfigReport::Format format)
{
  switch (format) {
  case vpConfigReport::Format::MULTI_CUE_JSON:
    return "vpMbMultiCueTracker's JSON";
  case vpConfigReport::Format::GENERIC_XML:
    return "vpMbGenericTracker's XML";
  case vpConfigReport::Format::CALIBRATION_XML:
    return "a camera's XML";
  case vpConfigReport::Format::GENERIC_JSON:
    return "vpMbGenericTracker's JSON";
  case vpConfigReport::Format::RENDER_BASED_JSON:
    return "vpRBTracker's JSON";
  case vpConfigReport::Format::NONE:
    break;
  }
  return "no file";
}

void vpConfigReport::leave(const std::string &setting, const std::string &reason)
{
  const auto others =
      std::stable_partition(taken.begin(), taken.end(), [&](const Item &item) { return item.setting != setting; });
  for (auto item = others; item != taken.end(); ++item) {
    left.push_back({item->name, "", reason});
  }
  taken.erase(others, taken.end());
}

std::ostream &operator<<(std::ostream &stream, const vpConfigReport &report)
{
  stream << "'" << report.file << "' is " << toString(report.format) << "\n";
  for (const vpConfigReport::Item &item : report.taken) {
    stream << "  taken  " << item.name << " as " << item.setting << (item.reason.empty() ? "" : ": ") << item.reason
           << "\n";
  }
  for (const vpConfigReport::Item &item : report.left) {
    stream << "  left   " << item.name << ": " << item.reason << "\n";
  }
  return stream;
}

END_VISP_NAMESPACE
