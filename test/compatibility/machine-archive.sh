# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# For the programs of this folder: which archive of Debian the machine's own apt uses.

# Prints "<uri> <keyring or ->" of the first source in apt's settings that is a Debian release, in either format.
machine_archive() {
  local files=() file
  for file in /etc/apt/sources.list.d/*.sources /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [[ -f $file ]] && files+=("$file")
  done
  ((${#files[@]})) || return 0
  # shellcheck source=/dev/null
  awk -v codename="$(. /etc/os-release && echo "${VERSION_CODENAME:-sid}")" '
    function release(suites,   list, n, i) {
      n = split(suites, list)
      for (i = 1; i <= n; i++)
        if (list[i] == codename || list[i] ~ /^(stable|testing|unstable|sid)$/) return 1
      return 0
    }
    function found(uri, key) { print uri, (key ~ /^\// ? key : "-"); done = 1; exit }
    function stanza(   u) {
      split(uris, u)
      if (types ~ /(^|[ \t])deb([ \t]|$)/ && enabled !~ /no/ && release(suites)) found(u[1], key)
      types = uris = suites = key = enabled = ""
    }
    FNR == 1 { stanza() }
    /^[ \t]*#/ { next }
    /^[ \t]*$/ { stanza(); next }
    /^deb[ \t]/ {
      line = $0; key = ""
      if (match(line, /\[[^]]*\]/)) {
        options = substr(line, RSTART + 1, RLENGTH - 2)
        if (match(options, /signed-by=[^ \t]*/)) key = substr(options, RSTART + 10, RLENGTH - 10)
        sub(/\[[^]]*\]/, "", line)
      }
      split(line, word)
      if (release(word[3])) found(word[2], key)
      key = ""; next
    }
    { field = tolower($1); value = $0; sub(/^[^:]*:[ \t]*/, "", value) }
    field == "types:" { types = value }
    field == "uris:" { uris = value }
    field == "suites:" { suites = value }
    field == "signed-by:" { key = value }
    field == "enabled:" { enabled = tolower(value) }
    END { if (!done) stanza() }
  ' "${files[@]}"
}
