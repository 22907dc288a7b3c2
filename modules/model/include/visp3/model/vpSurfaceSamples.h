// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpSurfaceSamples_h
#define vpSurfaceSamples_h

#include <visp3/model/vpTrackedModel.h>

#include <cstddef>
#include <vector>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_model_geometry
  A place on the object's surface.
*/
struct vpSurfaceSample
{
  Eigen::Vector3f position;      //!< Object frame, metres.
  Eigen::Vector3f normal;        //!< Unit outward normal of its triangle, object frame.
  bool seenFromBothSides = true; //!< False where the back of its face can never be seen.
};

/*!
  \ingroup group_model_geometry
  Places spread evenly over the whole surface by its area: the same ones for the same model.
  \param count How many are wanted; a model without triangles has none.
*/
VISP_EXPORT std::vector<vpSurfaceSample> vpSampleSurface(const vpTrackedModel &model, std::size_t count);

END_VISP_NAMESPACE
#endif
