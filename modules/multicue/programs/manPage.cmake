# SPDX-License-Identifier: GPL-2.0-or-later
# Installs a program with a man page that is made of what its --help prints. Run as a script, it makes that page.
if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND ${program} --help OUTPUT_VARIABLE help RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} --help ended with ${result}")
  endif()
  get_filename_component(name ${program} NAME)
  # What roff reads as its own: backslashes, and lines that begin with a dot or an apostrophe.
  string(REPLACE "\\" "\\e" help "${help}")
  string(REPLACE "-" "\\-" help "${help}")
  string(REPLACE "-" "\\-" title "${name}")
  string(REGEX REPLACE "(^|\n)([.'])" "\\1\\\\&\\2" help "${help}")
  string(FIND "${help}" "\nOptions:\n" at)
  string(SUBSTRING "${help}" 0 ${at} description)
  math(EXPR at "${at} + 10")
  string(SUBSTRING "${help}" ${at} -1 options)
  string(REGEX MATCH "^[^\n.:]*" summary "${description}")
  # An option is a line that begins with two blanks; what is set in deeper goes on, what is not set in ends them.
  string(REGEX REPLACE "\n\n([^ \n][^\n]*):\n" "\n.SH \\1\n" options "\n${options}")
  string(REGEX REPLACE "\n  (\\\\-[^ ]*( [A-Z]+)?) +([^\n]*)" "\n.TP\n.B \\1\n\\3" options "${options}")
  string(REGEX REPLACE "\n  ([^ \n][^ \n]*) +([^\n]*)" "\n.TP\n.B \\1\n\\2" options "${options}")
  string(REGEX REPLACE "\n +" "\n" options "${options}")
  file(WRITE ${page} ".TH \"${title}\" 1 \"\" \"multicue ${version}\" \"ViSP multi\\-cue tracking\"\n"
    ".SH NAME\n${title} \\- ${summary}\n.SH SYNOPSIS\n.B ${title}\n[\\fIoptions\\fR]\n"
    ".SH DESCRIPTION\n.nf\n${description}.fi\n.SH OPTIONS${options}"
    ".SH EXIT STATUS\n0, or 1 after a message of what is wrong.\n")
  return()
endif()

# multicue_install_program(<target>): with its man page, which is built with it.
function(multicue_install_program name)
  include(GNUInstallDirs)
  set(page ${CMAKE_CURRENT_BINARY_DIR}/${name}.1)
  add_custom_command(TARGET ${name} POST_BUILD BYPRODUCTS ${page}
    COMMAND ${CMAKE_COMMAND} -D "program=$<TARGET_FILE:${name}>" -D "page=${page}" -D "version=${PROJECT_VERSION}"
      -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    VERBATIM)
  # It finds the libraries from where they are installed together.
  file(RELATIVE_PATH libraries /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(${name} PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries}")
  install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
endfunction()
