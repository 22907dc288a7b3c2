# SPDX-License-Identifier: GPL-2.0-or-later
# What makes find_package(VISPMultiCue) work on an installed copy.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/VISPMultiCue)

# A static library's private libraries are linked by its users, so they have to be found again there.
set(static_dependencies "")
if(NOT BUILD_SHARED_LIBS)
  get_property(private_libraries GLOBAL PROPERTY MULTICUE_PRIVATE_LIBRARIES)
  foreach(dependency IN ITEMS
      "^OpenGL::|OpenGL COMPONENTS EGL OpenGL" "^assimp|assimp" "^opencv_|OpenCV" "^pugixml|pugixml"
      "^nlohmann_json|nlohmann_json" "^Threads::|Threads")
    string(REPLACE "|" ";" dependency ${dependency})
    list(GET dependency 0 pattern)
    list(GET dependency 1 package)
    set(used ${private_libraries})
    list(FILTER used INCLUDE REGEX ${pattern})
    if(used)
      string(APPEND static_dependencies "find_dependency(${package})\n")
    endif()
  endforeach()
endif()

configure_package_config_file(cmake/VISPMultiCueConfig.cmake.in ${PROJECT_BINARY_DIR}/VISPMultiCueConfig.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/VISPMultiCueConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/VISPMultiCueConfig.cmake ${PROJECT_BINARY_DIR}/VISPMultiCueConfigVersion.cmake
              cmake/SupportedVisp.cmake
  DESTINATION ${package_folder} COMPONENT development)
install(EXPORT VISPMultiCueTargets DESTINATION ${package_folder} COMPONENT development)
