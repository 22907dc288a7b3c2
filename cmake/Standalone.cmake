# SPDX-License-Identifier: GPL-2.0-or-later
# ViSP's module macros for a build against an installed ViSP, so that the modules' CMake files serve both builds.
include(GNUInstallDirs)
include(cmake/PkgConfig.cmake)

# ViSP's imported targets carry no include directories. Eigen is here because public headers use it.
add_library(installed_visp INTERFACE)
target_compile_features(installed_visp INTERFACE cxx_std_17)
target_include_directories(installed_visp SYSTEM INTERFACE "$<BUILD_INTERFACE:${VISP_INCLUDE_DIRS}>")
target_link_libraries(installed_visp INTERFACE Eigen3::Eigen)
install(TARGETS installed_visp EXPORT VISPMultiCueTargets)

# The libraries find each other, and a ViSP that is not in the system's folders, from where they are installed.
set(CMAKE_INSTALL_RPATH "$ORIGIN")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)

macro(vp_add_module module)
  set(the_module visp_${module})
  set(deps "")
  set(private "")
  set(kind REQUIRED)
  foreach(d ${ARGN})
    if(d MATCHES "^(PRIVATE_)?(REQUIRED|OPTIONAL)$")
      set(kind ${d})
    elseif(kind MATCHES "^PRIVATE_")
      list(APPEND private ${d})
    elseif(TARGET ${d})
      list(APPEND deps ${d})
    elseif(kind STREQUAL "REQUIRED")
      message(NOTICE "${the_module} is left out: ${d} was not found")
      return()
    endif()
  endforeach()
endmacro()

macro(vp_set_module_sources)
  cmake_parse_arguments(sources "" "" "HEADERS;SOURCES" ${ARGN})
endmacro()

macro(vp_module_include_directories)
  set(extra_includes ${ARGN})
endmacro()

macro(vp_create_module)
  add_library(${the_module} ${sources_SOURCES} ${sources_HEADERS})
  target_include_directories(${the_module}
    PRIVATE src
    PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>")
  target_include_directories(${the_module} SYSTEM PRIVATE ${extra_includes})
  target_link_libraries(${the_module}
    PUBLIC installed_visp ${deps}
    PRIVATE ${private} $<BUILD_INTERFACE:multicue_warnings>)
  target_compile_definitions(${the_module} PRIVATE visp_EXPORTS)
  multicue_first_build(${the_module} ${first_headers_${the_module}})
  set_target_properties(${the_module} PROPERTIES
    LINKER_LANGUAGE CXX # a module of headers alone has no source that would tell
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(TARGETS ${the_module} EXPORT VISPMultiCueTargets
    LIBRARY COMPONENT libraries NAMELINK_COMPONENT development
    ARCHIVE COMPONENT development)
  foreach(header ${sources_HEADERS})
    get_filename_component(folder ${header} DIRECTORY)
    string(REGEX REPLACE "^include" "${CMAKE_INSTALL_INCLUDEDIR}" folder ${folder})
    install(FILES ${header} DESTINATION ${folder} COMPONENT development)
  endforeach()
  multicue_write_pkg_config(${the_module} ${deps})
  set_property(GLOBAL APPEND PROPERTY MULTICUE_MODULES ${the_module})
  set_property(GLOBAL APPEND PROPERTY MULTICUE_PRIVATE_LIBRARIES ${private})
endmacro()

# As in ViSP, every source file under test/ is a program and a test.
macro(vp_add_tests)
  file(GLOB_RECURSE test_files CONFIGURE_DEPENDS test/*.cpp)
  foreach(file ${test_files})
    multicue_add_test(${file} ${the_module})
  endforeach()
endmacro()
