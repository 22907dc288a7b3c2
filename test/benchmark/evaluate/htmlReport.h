// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchHtmlReport_h
#define benchHtmlReport_h

#include "evaluate/evaluation.h"

namespace bench {

/*!
  A page that needs no other file: tables, success against step, error over time, overlays of the worst frames, and what
  failed.
*/
std::string toHtml(const Evaluation &evaluation);

} // namespace bench
#endif
