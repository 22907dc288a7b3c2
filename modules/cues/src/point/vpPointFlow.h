// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpPointFlow_h
#define vpPointFlow_h

#include "point/vpPointImage.h"

#include <visp3/cues/vpPointCue.h>

BEGIN_VISP_NAMESPACE

/*!
  Follows points from one image to another by pyramidal KLT, and back again: only what comes back to where it started is
  believed. The memory is used again from frame to frame.
*/
class vpPointFlow
{
public:
  void clear();
  //! \param from Place in the first image. \param seed Where to start in the second. Both in their area's coordinates.
  void add(const cv::Point2f &from, const cv::Point2f &seed);
  void run(const vpPointImage &first, const vpPointImage &second, const vpPointCueSettings &settings);

  std::size_t size() const { return m_from.size(); }
  bool isFound(std::size_t i) const { return m_found[i] != 0; }
  const cv::Point2f &place(std::size_t i) const { return m_to[i]; }
  //! What the points found were off their seeds by, in the middle of all; 0 where none was found.
  cv::Point2f medianCorrection();

private:
  // The way back needs no more levels of the pyramid than the points went far from their seeds.
  int levelsBack();

  std::vector<cv::Point2f> m_from, m_seed, m_to, m_back;
  std::vector<unsigned char> m_found, m_foundBack;
  std::vector<float> m_error, m_sorted;
};

END_VISP_NAMESPACE
#endif
