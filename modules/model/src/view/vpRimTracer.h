// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpRimTracer_h
#define vpRimTracer_h

#include "view/vpContourSampler.h"
#include "view/vpModelTopology.h"

BEGIN_VISP_NAMESPACE

/*!
  Follows the rims of curved faces: the curves where the interpolated corner normal is perpendicular to the line of
  sight. A triangle has one straight bit of such a curve or none, and hands it on through the side that it leaves by, so
  that curves come out whole and in order.
*/
class vpRimTracer
{
public:
  vpRimTracer(vpModelView &view, const vpModelTopology &topology, const vpViewCamera &camera);

  //! Finds all rims; they are kept in the view.
  void trace();
  //! Gives those that were found to \e sampler.
  void sample(vpContourSampler &sampler) const;

private:
  struct Step
  {
    std::size_t triangle;
    std::size_t side; //!< From this corner to the next one.
  };

  void computeFacing();
  float facing(std::size_t triangle, std::size_t corner) const;
  bool crosses(std::size_t triangle, std::size_t side) const;
  //! Sets 0 for each triangle that a rim crosses.
  void markRims(std::vector<char> &visited) const;
  void traceFrom(std::size_t triangle);
  std::size_t otherSide(std::size_t triangle, std::size_t side) const;
  bool advance(Step &step, std::size_t &entry) const;
  bool isConvexRim(std::size_t triangle) const;
  //! Adds where the rim crosses a side.
  void addNode(std::size_t triangle, std::size_t side, bool joined);
  const vpModelTriangle &triangleAt(std::size_t index) const;

  vpModelView &m_view;
  const vpTrackedModel &m_model;
  const vpModelTopology &m_topology;
  const vpViewCamera &m_camera;
};

END_VISP_NAMESPACE
#endif
