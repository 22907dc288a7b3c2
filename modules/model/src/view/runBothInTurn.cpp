// SPDX-License-Identifier: GPL-2.0-or-later
#include "view/runBoth.h"

BEGIN_VISP_NAMESPACE

// Compiled where OpenCV was not found.
void vpRunBoth(const std::function<void()> &first, const std::function<void()> &second)
{
  first();
  second();
}

END_VISP_NAMESPACE
