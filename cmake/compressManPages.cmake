# SPDX-License-Identifier: GPL-2.0-or-later
# Run by cpack on what goes into the packages: Debian has man pages compressed.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_DIRECTORY}/*.1)
list(FILTER pages INCLUDE REGEX "/man/man1/")
foreach(page ${pages})
  execute_process(COMMAND gzip -9nf ${page} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${page} cannot be compressed")
  endif()
endforeach()
