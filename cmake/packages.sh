# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The Debian packages that the project needs, and how to get them. Sourced by ./check and ./demo.

# shellcheck disable=SC2034 # used where this file is sourced
build_packages=(
  build-essential cmake ninja-build pkg-config
  libvisp-dev libopencv-dev libeigen3-dev libassimp-dev libpugixml-dev nlohmann-json3-dev
  libegl-dev libopengl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri
  visp-images-data
)
# shellcheck disable=SC2034
test_packages=(catch2 libbenchmark-dev)
# For the target doc; neither ./demo nor ./check makes it.
# shellcheck disable=SC2034
doc_packages=(doxygen graphviz)

# Installs those of the named packages that are missing; where that cannot be done, says how and carries on.
install_missing() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "Not a Debian or Ubuntu system: these packages, or what they are called here, have to be there: $*" >&2
    return
  fi
  local missing=() package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  local as_root=() install=(apt-get install -y --no-install-recommends "${missing[@]}")
  if ((EUID != 0)); then
    if ! sudo -n true 2>/dev/null && ! { [[ -t 0 ]] && sudo -v; }; then
      echo "Missing packages; install them with: sudo ${install[*]}" >&2
      return 0
    fi
    as_root=(sudo)
  fi
  echo "== Installing ${missing[*]}"
  local log
  log=$(mktemp)
  if ! { "${as_root[@]}" apt-get update && "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}"; } \
    >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "The packages could not be installed; the whole output is in $log" >&2
    return 1
  fi
  rm -f "$log"
}

# Prints the folder of ViSP's images, looked for where ViSP looks for it; fails where there is none.
visp_images() {
  local root=${VISP_INPUT_IMAGE_PATH:-} packaged=/usr/share/visp-images-data folder
  for folder in ${root:+"$root" "$root/ViSP-images" "$root/visp-images"} "$packaged/ViSP-images" "$packaged/visp-images"; do
    if [[ -f $folder/mbt/cube.cao ]]; then
      echo "$folder"
      return 0
    fi
  done
  echo "ViSP's images were not found: install visp-images-data, or set VISP_INPUT_IMAGE_PATH to their folder" >&2
  return 1
}
