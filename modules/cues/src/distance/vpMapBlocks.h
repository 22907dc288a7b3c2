// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpMapBlocks_h
#define vpMapBlocks_h

#include <visp3/cues/vpImageRegion.h>

BEGIN_VISP_NAMESPACE

/*!
  A region in whole map pixels of \e block image pixels each. They are those of the whole image's map, so that a region
  that moves gives the same values; the last ones may be cut off by the image's border.
*/
struct vpMapBlocks
{
  vpMapBlocks(const vpImageRegion &roi, int block, unsigned int width, unsigned int height)
  {
    const vpImageRegion inside = roi.clipped(width, height);
    const int left = inside.left / block * block;
    const int top = inside.top / block * block;
    region = vpImageRegion(left, top, inside.left - left + inside.width, inside.top - top + inside.height);
    columns = (region.width + block - 1) / block;
    rows = (region.height + block - 1) / block;
    region = vpImageRegion(left, top, columns * block, rows * block).clipped(width, height);
  }

  vpImageRegion region; //!< Within the image.
  int columns = 0;      //!< Map pixels.
  int rows = 0;
};

END_VISP_NAMESPACE
#endif
