// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpEstimate_h
#define vpEstimate_h

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/se3/vpCompatibility.h>

#include <optional>

BEGIN_VISP_NAMESPACE

//! A pose that an estimation begins at.
struct vpStart
{
  //! How it is brought to the image.
  enum Way
  {
    COARSE_TO_FINE, //!< Points first, then the colours' coarse levels, which both reach far, then all cues.
    BY_COLORS,      //!< The colours' coarse levels, then all cues.
    FINE,           //!< All cues near the pose.
    AS_VIEWED       //!< The same, where the last view may serve.
  };

  vpHomogeneousMatrix cMo;
  Way way = FINE;
  //! A result a diameter or more away from here has diverged; none: away from the start.
  std::optional<vpHomogeneousMatrix> origin = std::nullopt;
  bool holdsPrediction = false; //!< What the image does not show stays as expected, else as it is at the start.

  const vpHomogeneousMatrix &from() const { return origin ? *origin : cMo; }
};

//! Where an estimation ended.
struct vpEstimate
{
  vpHomogeneousMatrix cMo;
  bool isFound = false;    //!< False where nothing in the image leads to a pose; cMo is where it gave up.
  bool usesPoints = false; //!< They took part, and agreed with the other cues.
};

END_VISP_NAMESPACE
#endif
