// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "covarianceTrials.h"

using namespace covarianceTrials;

TEST_CASE("Covariances agree at another pose and other noise", "[covariance]")
{
  checkConsistency(vpHomogeneousMatrix(0.01, 0.01, 0.45, 2.3, -0.3, 0.2), {5., 8.}, 200);
}
