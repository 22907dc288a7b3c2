# SPDX-License-Identifier: GPL-2.0-or-later
# Most of the time that compiling takes goes into reading headers and what they instantiate. ./demo, which builds once and
# from nothing, does so once for each library, and once for all sources of the tracker's many calls. Other builds do without:
# there, a source that forgot an include shall not compile, and ccache shall know each object file.
option(FIRST_BUILD "For a single build from nothing: headers are compiled once for each library" OFF)

# multicue_first_build(<target> <header>...): those headers, beside what all libraries read.
function(multicue_first_build target)
  if(NOT FIRST_BUILD)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <map> <memory> <optional> <sstream>
    <string> <vector>
    <Eigen/Cholesky> <Eigen/Eigenvalues> <Eigen/Geometry>
    <visp3/core/vpCameraParameters.h> <visp3/core/vpException.h> <visp3/core/vpHomogeneousMatrix.h>
    <visp3/core/vpImage.h> ${ARGN})

  get_target_property(calls ${target} SOURCES)
  list(FILTER calls INCLUDE REGEX "^src/facade/.*\\.cpp$")
  list(FILTER calls EXCLUDE REGEX "Cao\\.cpp$") # A class of its own has a member of an unnamed namespace's type.
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(group 1)
  foreach(source ${calls})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP facade${group})
    math(EXPR group "${group} % 4 + 1") # As many as a machine of today has cores.
  endforeach()
endfunction()

set(first_headers_visp_cues <visp3/cues/vpColorCue.h> <visp3/cues/vpEdgeCue.h> <visp3/cues/vpPointCue.h>)
set(first_headers_visp_multicue ${first_headers_visp_cues} <visp3/multicue/vpMbMultiCueTracker.h>)
