// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpCurves_h
#define vpCurves_h

#include "view/vpContourSampler.h"
#include "view/vpModelTopology.h"

BEGIN_VISP_NAMESPACE

//! The curves that a model declares or that were found when it was loaded, as they are seen from one pose.
class vpCurves
{
public:
  vpCurves(const vpTrackedModel &model, const vpModelTopology &topology, const std::vector<char> &facesSeen,
           const vpViewCamera &camera, const vpModelViewOptions &options);

  void addEdges(vpContourSampler &sampler) const;
  //! The two lines of a cylinder's mantle where it turns away from the camera.
  void addLimbs(vpContourSampler &sampler) const;
  void addCircles(vpContourSampler &sampler) const;

  //! Number of values of vpControlPoint::edge: edges, then limbs, then circles.
  static int names(const vpTrackedModel &model);

private:
  struct EdgeSight
  {
    bool seen = false;
    bool inner = false;                                //!< Surface on both sides.
    Eigen::Vector3d outward = Eigen::Vector3d::Zero(); //!< Away from the only face that is seen, zero if not known.
  };

  EdgeSight look(const vpModelEdge &edge) const;
  bool isTracked(int face) const;
  bool isTracked(const vpModelEdge &edge) const;
  bool isLongEnough(const vpModelEdge &edge) const;

  const vpTrackedModel &m_model;
  const vpModelTopology &m_topology;
  const std::vector<char> &m_facesSeen;
  const vpViewCamera &m_camera;
  const vpModelViewOptions &m_options;
};

END_VISP_NAMESPACE
#endif
