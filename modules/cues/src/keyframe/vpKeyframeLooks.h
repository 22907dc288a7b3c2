// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpKeyframeLooks_h
#define vpKeyframeLooks_h

#include "point/vpSurfacePatch.h"
#include "point/vpSurfaceReader.h"

#include <visp3/cues/vpCueFrame.h>

#include <opencv2/core.hpp>

#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE

// What the places of features on the object looked like in one image, to tell whether another one shows the same there.
class vpKeyframeLooks
{
public:
  // \param place Of the surface, in the image.
  void add(const vpCueFrame &frame, const vpSurfaceElement &surface, const cv::Point2f &place);
  std::size_t size() const { return m_looks.size(); }
  // \param camera Of the image, at the object's pose in it.
  bool isSeenAgain(std::size_t number, const vpCueFrame &frame, const vpPointCamera &camera) const;

private:
  struct Look
  {
    vpSurfaceElement surface;
    vpSurfacePatch patch;
  };
  std::vector<Look> m_looks;
};

END_VISP_NAMESPACE
#endif
