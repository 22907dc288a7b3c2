# SPDX-License-Identifier: GPL-2.0-or-later
# Runs the second half of ./demo: the video is written, and our tracker has the box at the end.
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})
execute_process(COMMAND ${demo} --images none --data ${data} --sequence 2 --scale 0.25
    --save ${work}/demo.mp4 --summary ${work}/summary.txt
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "multicue-demo ended with ${result}:\n${output}")
endif()
file(READ ${work}/summary.txt summary)
string(FIND "${summary}" "  vpMbMultiCueTracker\n" at)
string(SUBSTRING "${summary}" ${at} -1 ours)
if(NOT ours MATCHES "held to the end|found again in image")
  message(FATAL_ERROR "The box was lost and not found again:\n${summary}")
endif()
file(GLOB videos ${work}/demo.*) # .avi where OpenCV has no encoder for .mp4
list(GET videos 0 video)
file(SIZE ${video} size)
if(size LESS 10000)
  message(FATAL_ERROR "The video ${video} has only ${size} bytes")
endif()
