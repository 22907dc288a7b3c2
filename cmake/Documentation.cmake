# SPDX-License-Identifier: GPL-2.0-or-later
# The target doc: web pages in doc/html of the build folder, with the pictures that the pages' own commands make.
find_package(Doxygen 1.9 QUIET COMPONENTS dot)
set(doc_programs multicue-check multicue-track multicue-generate multicue-evaluate multicue-starts tutorial-multicue-tracker-minimal
  tutorial-multicue-hypotheses tutorial-multicue-particles)
foreach(program ${doc_programs})
  if(NOT TARGET ${program})
    message(STATUS "There is no target doc: its pictures need ${program}")
    return()
  endif()
endforeach()

set(doc_folder ${PROJECT_BINARY_DIR}/doc)
set(run_pages ${PROJECT_SOURCE_DIR}/tutorial/run-pages ${doc_folder}/run
  $<TARGET_FILE_DIR:multicue-track> $<TARGET_FILE_DIR:multicue-generate> $<TARGET_FILE_DIR:tutorial-multicue-tracker-minimal>)
if(BUILD_TESTING)
  add_test(NAME tutorial-pages COMMAND ${PROJECT_SOURCE_DIR}/tutorial/run-pages ${PROJECT_BINARY_DIR}/tutorial-pages
    $<TARGET_FILE_DIR:multicue-track> $<TARGET_FILE_DIR:multicue-generate>
    $<TARGET_FILE_DIR:tutorial-multicue-tracker-minimal>)
  set_tests_properties(tutorial-pages PROPERTIES TIMEOUT 900)
endif()
if(NOT DOXYGEN_FOUND OR NOT TARGET Doxygen::dot)
  message(STATUS "There is no target doc: Doxygen or dot was not found (Debian: doxygen, graphviz)")
  return()
endif()

set(doc_pictures ${doc_folder}/run/pictures)
set(doc_printed ${doc_folder}/run/printed)
configure_file(cmake/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
add_custom_target(doc
  COMMAND ${CMAKE_COMMAND} -E make_directory ${doc_folder}
  COMMAND ${run_pages}
  COMMAND Doxygen::doxygen ${PROJECT_BINARY_DIR}/Doxyfile
  COMMENT "Running the tutorials' commands, and making ${doc_folder}/html"
  VERBATIM)
add_dependencies(doc ${doc_programs})
install(DIRECTORY ${doc_folder}/html DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/libvisp-multicue-doc
  COMPONENT documentation OPTIONAL)
