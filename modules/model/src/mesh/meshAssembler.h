// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef meshAssembler_h
#define meshAssembler_h

#include "meshTopology.h"
#include "modelParts.h"

#include <visp3/model/vpTrackedModelBuilder.h>

BEGIN_VISP_NAMESPACE
namespace vpMeshDetail {
//! A triangle soup whose corners are welded already.
struct WeldedSoup
{
  std::vector<IndexTriangle> triangles; //!< Indices into ModelParts::vertices.
  double tolerance;                     //!< Of the welding, metres.
  double creaseAngle;                   //!< Degrees.
  double smallestLoop;                  //!< Border loops with a smaller bounding box are not tracked, metres.
};

//! Adds the surface and the tracked edges of a mesh to a model. \param appearance Of the soup, see vpModelAppearance.
void addMesh(ModelParts &parts, const WeldedSoup &soup, const vpModelAppearance &appearance);
} // namespace vpMeshDetail
END_VISP_NAMESPACE
#endif
