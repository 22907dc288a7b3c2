// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpImageStanding_h
#define vpImageStanding_h

#include "search/vpPointProjection.h"
#include "search/vpStartSearch.h"

#include <visp3/cues/vpOrientedDistanceMap.h>

BEGIN_VISP_NAMESPACE

/*
  How well an image agrees with a pose, by edges and the model's colours, beside what it agrees with at poses of the
  same size: small poses agree better with anything than large ones do.
*/
class vpImageStanding
{
public:
  // All have to live as long as poses are asked about. edges: of all of the frame. look: has the frame, and the model's
  // colours where these are used. What was usual is forgotten.
  void setFrame(const vpCueFrame &frame, vpViewSphere &sphere, const vpOrientedDistanceMap &edges,
                const vpStartSearch &look);
  // The object's diameter in the image at a pose, pixels; 0 behind the camera.
  double sizeOf(const Eigen::Isometry3d &cMo) const;
  // About 1 where the pose is right; without regard to its size. every: colours are looked at by one place in so many.
  double value(const Eigen::Isometry3d &cMo, std::size_t every) const;
  // What values poses of a size have in the mean; from the smallest size to the largest.
  void addUsual(double size, double mean) { m_usual.push_back({size, mean}); }
  // Between the sizes that were added.
  double usualOf(double size) const;
  // By how many deviations the value is better than what is usual.
  double operator()(const vpHomogeneousMatrix &cMo, std::size_t every) const;
  static constexpr double deviation = 0.08;

private:
  struct Usual
  {
    double size = 0.; // Pixels.
    double mean = 0.;
  };
  double edgesAt(const Eigen::Isometry3d &cMo, double size, double &inside) const;

  const vpStartSearch *m_look = nullptr;
  const vpOrientedDistanceMap *m_edges = nullptr;
  vpViewSphere *m_sphere = nullptr;
  vpPointCamera m_camera;
  std::vector<Usual> m_usual;
};

END_VISP_NAMESPACE
#endif
