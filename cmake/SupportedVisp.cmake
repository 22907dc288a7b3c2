# SPDX-License-Identifier: GPL-2.0-or-later
# ViSP's version file accepts every later version; this says which ones were tried. Read here and by users' builds.
if(VISP_VERSION VERSION_GREATER_EQUAL 3.8)
  message(WARNING "ViSP ${VISP_VERSION} in ${VISP_DIR} is newer than the versions that the multi-cue modules "
                  "are tested with (3.5 to 3.7).")
endif()
