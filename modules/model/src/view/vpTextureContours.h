// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTextureContours_h
#define vpTextureContours_h

#include "view/vpContourSampler.h"
#include "view/vpPointGrid.h"

#include <visp3/model/vpTextureEdges.h>

#include <mutex>

BEGIN_VISP_NAMESPACE

//! What all views of a model know of its texture's edges: they are found when the first view asks for them.
class vpTextureSource
{
public:
  const std::vector<vpTextureEdge> &edges(const vpTrackedModel &model)
  {
    std::call_once(m_once, [&] { m_edges = vpFindTextureEdges(model); });
    return m_edges;
  }

private:
  std::once_flag m_once;
  std::vector<vpTextureEdge> m_edges;
};

//! Adds the control points of a texture's edges to those of the geometry.
class vpTextureContours
{
public:
  //! \param view Holds the control points of the geometry.
  vpTextureContours(vpModelView &view, const vpViewCamera &camera, const vpModelViewOptions &options);

  //! \param firstName vpControlPoint::edge of the first of \e edges.
  void add(const std::vector<vpTextureEdge> &edges, int firstName, vpContourSampler &sampler);

private:
  bool isSeen(const vpTextureEdge &edge) const;
  double clearance(const vpTextureEdge &edge) const;
  void keepUnambiguous(std::size_t firstContour);
  vpContour longestRun(const vpContour &contour) const;

  vpModelView &m_view;
  const vpViewCamera &m_camera;
  const vpModelViewOptions &m_options;
  vpPointGrid m_grid;
};

END_VISP_NAMESPACE
#endif
