// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpImageStanding_h
#define vpImageStanding_h

#include "search/vpPointProjection.h"
#include "search/vpStartSearch.h"

#include <visp3/cues/vpOrientedDistanceMap.h>

#include <array>

BEGIN_VISP_NAMESPACE

/*
  How much likelier an image is with the object at a pose than without it, as a logarithm of odds: by how near the
  image's edges are to the contours, and by the model's colours.

  A contour point whose nearest edge is d pixels away counts log(p(d) / q(d)): p is how often right poses have such a
  distance, q how often this image has it anywhere. So an edge says little where all is full of edges, and a contour
  without one speaks against the pose. The sum over the contours, rather than their mean, is compared: a pose that
  explains many edges is likelier than one that shows few of them, such as the object's back.
*/
class vpImageStanding
{
public:
  // All have to live as long as poses are asked about. edges: of all of the frame. look: has the frame, and the model's
  // colours where these are used.
  void setFrame(const vpCueFrame &frame, vpViewSphere &sphere, const vpOrientedDistanceMap &edges,
                const vpStartSearch &look);
  // The object's diameter in the image at a pose, pixels; 0 behind the camera.
  double sizeOf(const Eigen::Isometry3d &cMo) const;
  // every: colours are looked at by one place in so many. unseen where the object is hardly in the image.
  double operator()(const Eigen::Isometry3d &cMo, std::size_t every) const;
  static constexpr double unseen = -100.;

private:
  // What a contour says whose edge is so many whole pixels away, or in the last place as far as a map of
  // vpImageSearch reaches, which is 16 pixels, or farther.
  static constexpr std::size_t distances = 17;
  using Ratios = std::array<double, distances>;
  static Ratios ratios(const vpOrientedDistanceMap &edges, unsigned int width, unsigned int height);
  double edgesAt(const Eigen::Isometry3d &cMo, double &inside) const;

  const vpStartSearch *m_look = nullptr;
  const vpOrientedDistanceMap *m_edges = nullptr;
  vpViewSphere *m_sphere = nullptr;
  vpPointCamera m_camera;
  Ratios m_ratios = {};
};

END_VISP_NAMESPACE
#endif
