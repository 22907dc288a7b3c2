# SPDX-License-Identifier: GPL-2.0-or-later
# cpack -G DEB: the libraries, what programs are built with, the tools, and the documentation, as Debian has them.
set(CPACK_PACKAGE_NAME visp-multicue)
set(CPACK_PACKAGE_VENDOR "")
# Who makes the packages, as Debian's own tools ask for it; else who made the last commit. Without either cpack says that a
# contact is missing.
set(contact "")
if(DEFINED ENV{DEBEMAIL})
  set(contact "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  find_package(Git QUIET)
  if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} log -1 "--format=%an <%ae>" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
      OUTPUT_VARIABLE contact OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
endif()
set(CPACK_PACKAGE_CONTACT "${contact}" CACHE STRING "Name and address of who makes the packages")
set(CPACK_PACKAGE_HOMEPAGE_URL "https://visp.inria.fr")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL libraries development tools)
if(TARGET doc)
  list(APPEND CPACK_COMPONENTS_ALL documentation)
endif()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SOURCE visp-multicue)
# Programs and the module multicue need the other libraries, which are not installed while the packages are made.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "")
get_property(modules GLOBAL PROPERTY MULTICUE_MODULES)
foreach(module ${modules})
  string(REPLACE visp_ "" folder ${module})
  list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/modules/${folder})
endforeach()

# The number behind the name is that of the libraries' SONAME: libraries of another one can be installed beside them.
set(library libvisp-multicue${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(description "model-based tracking with edges, points and colours for ViSP")

set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME ${library})
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_MULTIARCH same) # written by CMake 3.31 and later
set(CPACK_COMPONENT_LIBRARIES_DESCRIPTION "${description} (libraries)
Follows the pose of a known rigid object in the images of one camera, says how
far to believe it, and finds a lost object again.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libvisp-multicue-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "${library} (= ${PROJECT_VERSION}), libvisp-dev, libeigen3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_MULTIARCH same)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS libvisp-multicue-doc)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "${description} (development files)
Headers, and what CMake and pkg-config need to find the libraries.")

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME multicue-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${library} (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_TOOLS_DESCRIPTION "${description} (programs)
Programs that track an object in videos, images or with a camera, render
sequences with known poses, and measure trackers on them.")

set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_NAME libvisp-multicue-doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_COMPONENT_DOCUMENTATION_DESCRIPTION "${description} (documentation)
Tutorials, theory and reference as web pages.")

# What every package has in its folder of documents.
string(TIMESTAMP package_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(cmake/debian/changelog.in ${PROJECT_BINARY_DIR}/debian/changelog @ONLY)
find_program(GZIP_PROGRAM gzip)
if(GZIP_PROGRAM)
  execute_process(COMMAND ${GZIP_PROGRAM} -9nf ${PROJECT_BINARY_DIR}/debian/changelog)
  foreach(component ${CPACK_COMPONENTS_ALL})
    string(TOUPPER ${component} upper)
    install(FILES cmake/debian/copyright ${PROJECT_BINARY_DIR}/debian/changelog.gz
      DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME}
      COMPONENT ${component} EXCLUDE_FROM_ALL)
  endforeach()
endif()
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/compressManPages.cmake)
include(CPack)
