// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef runBoth_h
#define runBoth_h

#include <visp3/se3/vpCompatibility.h>

#include <functional>

BEGIN_VISP_NAMESPACE

//! Runs two tasks that share nothing, at the same time where OpenCV may use more than one thread.
//! \throw What the first one of them throws that throws.
void vpRunBoth(const std::function<void()> &first, const std::function<void()> &second);

END_VISP_NAMESPACE
#endif
