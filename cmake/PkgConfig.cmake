# SPDX-License-Identifier: GPL-2.0-or-later
# A pkg-config file for each module: pkg-config --cflags --libs visp_multicue. ViSP's own visp.pc gives the flags to compile
# with; it names far more libraries than a program needs, so that those of ViSP's modules are listed here instead.
function(multicue_write_pkg_config module)
  set(pc_name ${module})
  set(pc_requires "")
  set(visp_modules "")
  foreach(dependency ${ARGN})
    get_property(ours GLOBAL PROPERTY MULTICUE_MODULES)
    if(dependency IN_LIST ours)
      list(APPEND pc_requires ${dependency})
    elseif(dependency MATCHES "^visp_")
      list(APPEND visp_modules ${dependency})
    endif()
  endforeach()
  list(JOIN pc_requires " " pc_requires)
  list(TRANSFORM visp_modules PREPEND "-l")
  get_target_property(core visp_core LOCATION)
  get_filename_component(visp_folder ${core} DIRECTORY)
  list(JOIN visp_modules " " pc_visp_libraries)
  string(PREPEND pc_visp_libraries "-L${visp_folder} ")

  # Relative to where the file is, so that an installed copy can be moved and put anywhere.
  file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" up "${up}")
  set(pc_prefix "\${pcfiledir}/${up}")
  set(pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
  set(pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/module.pc.in ${PROJECT_BINARY_DIR}/${module}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${module}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT development)
endfunction()
