# SPDX-License-Identifier: GPL-2.0-or-later
# Installs the build into a new prefix, then builds and runs the consumer against that copy.
set(work ${build}/installed-package)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${result}:\n${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${build} --prefix ${work}/prefix --config ${build_type})
string(REPLACE ";" "," modules "${modules}") # A list would be taken apart on its way, and all but its first entry be lost.
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${work}/build -G ${generator} -D CMAKE_BUILD_TYPE=${build_type}
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags} -D CMAKE_PREFIX_PATH=${work}/prefix
  -D VISP_DIR=${visp} -D modules=${modules})
run(${CMAKE_COMMAND} --build ${work}/build --config ${build_type})
run(${work}/build/consumer)
# What is installed beside the libraries.
if(modules MATCHES "visp_multicue")
  file(GLOB_RECURSE schema ${work}/prefix/*/visp-multicue/multicue-settings.schema.json)
  if(NOT schema)
    message(FATAL_ERROR "multicue-settings.schema.json is not installed")
  endif()
endif()
