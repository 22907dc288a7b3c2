// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpTextureEdges_h
#define vpTextureEdges_h

#include <visp3/model/vpTrackedModel.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_geometry
  A straight edge of what is printed or painted on the surface.
*/
struct vpTextureEdge
{
  std::array<Eigen::Vector3d, 2> position; //!< Its ends on the surface, object frame, metres.
  Eigen::Vector3d normal;                  //!< Unit outward normal of the surface at its middle, object frame.
  double contrast = 0.;                    //!< Difference of both sides, gray levels, > 0; seen from outside, the
                                           //!< brighter side is on the left when going from the first end.
  double clearance = 0.; //!< Distance to what else is printed beside it, metres; large ones are cut off. Edges whose
                         //!< clearance is a few pixels in the image move there with the blur.
  bool oriented = true;  //!< True where the back of the surface can never be seen.
};

/*!
  \ingroup group_model_geometry
  What counts as an edge of the texture.
*/
struct VISP_EXPORT vpTextureEdgeOptions
{
  double resolution = 400.;    //!< Pixels per diameter that the surface is drawn with, [50, 4000]; about as many as the
                               //!< object has in an image, as finer print blurs there.
  double minContrast = 30.;    //!< Smallest difference of both sides, gray levels, (0, 255].
  double minLength = 0.03;     //!< Of an edge, share of the diameter, (0, 1].
  unsigned int maxEdges = 400; //!< The strongest and longest are kept, >= 1.

  //! \throw vpException naming the first member out of range.
  void check() const;
};

/*!
  \ingroup group_model_geometry
  Finds the strong edges of a model's own texture or colours, which serve as further control points inside the
  silhouette ([P14] III-A).

  The surface, not a view of it, is looked at: each plane, and each part of a curved face that looks in about one
  direction, is drawn without light or perspective; the edges there are found to a fraction of a pixel, put back on the
  surface, and cut into straight bits. This takes tenths of a second, once for each model.
  \param model A model; one without texture and colours has no such edges.
  \param options What to take.
  \return The best ones first: those with the largest product of contrast and length.
  \throw vpException where an option is out of range.
*/
VISP_EXPORT std::vector<vpTextureEdge> vpFindTextureEdges(const vpTrackedModel &model,
                                                          const vpTextureEdgeOptions &options = vpTextureEdgeOptions());

END_VISP_NAMESPACE
#endif
