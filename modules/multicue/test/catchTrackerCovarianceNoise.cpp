// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "covarianceTrials.h"

using namespace covarianceTrials;

TEST_CASE("Covariances agree at other noise", "[covariance]")
{
  checkConsistency(noisyBox::pose(), {5., 8.}, 200);
}
