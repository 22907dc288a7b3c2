// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpColorLineFinder_h
#define vpColorLineFinder_h

#include "color/vpContourBars.h"

#include <visp3/cues/vpColorCue.h>

BEGIN_VISP_NAMESPACE

/*!
  Lays the lines across the silhouette of a view and reads their pixels. A line ends at the image's border, before the
  first pixel that is masked, and where it meets the silhouette again.
*/
class vpColorLineFinder
{
public:
  vpColorLineFinder(vpColorCue &cue, const vpCueFrame &frame);

  //! \param least Pixels that a line needs on either side of the contour; those with fewer are left out.
  void find(const vpModelView &view, int least);

private:
  void choose(const vpModelView &view);
  bool fit(vpColorCue::Line &line, int least) const;
  bool clipToImage(vpColorCue::Line &line) const;
  void clipToMask(vpColorCue::Line &line) const;

  vpColorCue &m_cue;
  const vpCueFrame &m_frame;
  vpContourBars m_bars;
};

END_VISP_NAMESPACE
#endif
