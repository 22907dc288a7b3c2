# SPDX-License-Identifier: GPL-2.0-or-later
# An interface target with the warnings that our own code is kept free of: ViSP's own, and those of its contributions.
add_library(multicue_warnings INTERFACE)
target_compile_options(multicue_warnings INTERFACE
  $<$<CXX_COMPILER_ID:GNU,Clang>:-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow
  -Wfloat-equal>)
