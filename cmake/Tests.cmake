# SPDX-License-Identifier: GPL-2.0-or-later
# Catch2 under the names that ViSP's tree gives it, and the function that makes a test of a source file.

if(BUILD_TESTING)
  find_package(Catch2 QUIET)
  if(Catch2_FOUND)
    set(CATCH2_INCLUDE_DIRS "") # they come with the target
    set(CATCH2_LIBRARIES multicue_catch_main)
    add_library(multicue_catch_main STATIC modules/se3/test-support/catchMain.cpp)
    target_link_libraries(multicue_catch_main PUBLIC Catch2::Catch2 installed_visp)
    target_compile_definitions(multicue_catch_main INTERFACE MULTICUE_CATCH_MAIN_IS_LINKED)
  else()
    message(WARNING "The tests are left out: Catch2 was not found (Debian: catch2).")
  endif()
endif()

# multicue_add_test(<source> <library>...): an executable with the file's name, and a test that runs it.
function(multicue_add_test source)
  if(NOT BUILD_TESTING OR NOT Catch2_FOUND)
    return()
  endif()
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE ${ARGN} ${CATCH2_LIBRARIES} multicue_warnings)
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES TIMEOUT 600) # seconds; with sanitizers, the longest take half of it
endfunction()
