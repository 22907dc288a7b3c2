// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef programsCheckedModel_h
#define programsCheckedModel_h

#include "check/checkReport.h"

#include <visp3/model/vpModelRenderer.h>

#include <memory>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace programs {

//! Size, origin, holes and winding of a model.
void checkGeometry(const vpTrackedModel &model, CheckReport &report);

//! How many control points its edges have, seen from all around, and what draws the depth that hides the others.
void checkViews(const std::shared_ptr<const vpTrackedModel> &model, vpModelRenderer::Preference preference,
                CheckReport &report);

} // namespace programs
#endif
