// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpBlobFinder_h
#define vpBlobFinder_h

#include <visp3/cues/vpColorOddsMap.h>

#include <vector>

BEGIN_VISP_NAMESPACE

// A place in the image that has the object's colours inside and others around.
struct vpBlob
{
  double u = 0.; // Pixels.
  double v = 0.;
  double size = 0.; // Side of the window that fits, pixels.
  double contrast = 0.;
};

/*
  Finds places of about the object's size and colours. Windows of several sizes are compared with what is around them on
  a coarse grid of the image.
*/
class vpBlobFinder
{
public:
  // Their middles may be outside the image. size: expected side of the window, pixels. The best one first; none where
  // no place stands out.
  const std::vector<vpBlob> &find(const vpColorOddsMap &colors, unsigned int width, unsigned int height, double size,
                                  std::size_t most);

private:
  void sumUp(const vpColorOddsMap &colors);
  double sum(int left, int top, int right, int bottom) const;
  double cells(int column, int row, int half) const;
  double contrastAt(int column, int row, int half) const;

  int m_columns = 0;
  int m_rows = 0;
  std::vector<double> m_sums;
  std::vector<vpBlob> m_found;
  std::vector<vpBlob> m_kept;
};

END_VISP_NAMESPACE
#endif
