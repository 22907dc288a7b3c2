// SPDX-License-Identifier: GPL-2.0-or-later
#include "dataset/sequence.h"
