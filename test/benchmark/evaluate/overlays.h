// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef benchOverlays_h
#define benchOverlays_h

#include "evaluate/evaluation.h"

namespace bench {

//! One frame of a scene with the model drawn where each tracker saw it.
struct OverlayRow
{
  struct Panel
  {
    std::string tracker;
    std::string caption; //!< Errors and state.
    std::string jpeg;    //!< Base64.
  };

  std::string title;
  std::vector<Panel> panels;
};

/*!
  The frames in which the trackers were most wrong: of each scene, protocol and step, the worst counted frame of each
  tracker, \e most rows in all, the worst ones first.
*/
std::vector<OverlayRow> worstFrames(const Evaluation &evaluation, std::size_t most);

} // namespace bench
#endif
