// SPDX-License-Identifier: GPL-2.0-or-later
// The runner and main() of every test, compiled once.
#include "catchMain.h"
