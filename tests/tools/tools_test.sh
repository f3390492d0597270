#!/usr/bin/env bash
# tools_test.sh CMAKE: runs the scripts in tools/ like a new user. Installs and builds nothing.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
cmake=$1
# shellcheck source-path=SCRIPTDIR source=../../tools/common.sh
source "$root/tools/common.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

eventually() {
  local tries
  for ((tries = 0; tries < 600; ++tries)); do
    "$@" && return
    sleep 0.05
  done
  fail "waited 30 s in vain for: $*"
}

each_explains_itself_and_leaves_nothing_behind() {
  local tool
  mkdir "$folder/left"
  for tool in setup build check demo build-qwt format tidy; do
    [[ $(TMPDIR=$folder/left "$root/tools/$tool" --help) == "tools/$tool"* ]] ||
      fail "tools/$tool --help does not say what it does"
    [[ -z $(ls -A "$folder/left") ]] || fail "tools/$tool --help leaves a file behind"
  done
}

is_found_through_a_link() {
  ln -s "$root/tools/check" "$folder/check"
  "$folder/check" --help >/dev/null || fail "tools/check does not work through a symbolic link"
}

what_is_no_option_is_refused() {
  local tool
  for tool in setup build check demo build-qwt format tidy; do
    ! "$root/tools/$tool" --nonsense too 2>"$folder/error" || fail "tools/$tool takes --nonsense"
    grep -q "^usage: tools/$tool" "$folder/error" || fail "tools/$tool does not say how it is used"
  done
}

a_preset_that_is_none_is_refused_and_leaves_no_folder() {
  ! (build_preset nonsense) 2>"$folder/error" || fail "preset nonsense was built"
  grep -q "no preset 'nonsense'; there are: .*dev" "$folder/error" || fail "$(<"$folder/error")"
  [[ ! -e $root/build/nonsense ]] || fail "preset nonsense left a folder"
}

shell_and_cmake_share_one_cache() {
  # shellcheck disable=SC2016  # expanded by cmake
  printf 'include(%s)\nmessage("${TENDON_CACHE}")\n' "$root/cmake/tendon_cache.cmake" >"$folder/print.cmake"
  local settings in_shell in_cmake
  for settings in "HOME=/a XDG_CACHE_HOME=/b" "HOME=/a XDG_CACHE_HOME=" "HOME=/a" "HOME=" "NEITHER="; do
    # shellcheck disable=SC2086,SC2016  # words; expanded by the inner shell
    in_shell=$(env -u HOME -u XDG_CACHE_HOME $settings bash -c 'source "$0" && echo "$TENDON_CACHE"' \
      "$root/tools/common.sh")
    # shellcheck disable=SC2086
    in_cmake=$(env -u HOME -u XDG_CACHE_HOME $settings "$cmake" -P "$folder/print.cmake" 2>&1)
    [[ $in_shell == "$in_cmake" ]] || fail "with $settings the tools use $in_shell, CMake $in_cmake"
  done
}

sudo_does_not_make_the_build_roots() {
  ((EUID == 0)) || return 0
  printf '#!/bin/sh\necho "$@"\n' >"$folder/sudo"
  chmod +x "$folder/sudo"
  local called
  called=$(SUDO_USER=somebody PATH=$folder:$PATH "$root/tools/check" --preset dev)
  [[ $called == "-H -u somebody -- $root/tools/check --preset dev" ]] || fail "called through sudo, it did: $called"
}

one_build_at_a_time() {
  local order=$folder/order
  must_be_preset() { :; }
  configure_and_build() {
    echo begin >>"$order"
    [[ $1 == second ]] || eventually test -e "$folder/go"
    echo end >>"$order"
  }
  TENDON_ROOT=$folder
  : >"$order"
  build_preset first &
  eventually test -s "$order"
  ln -s first "$folder/build/second"
  build_preset second >"$folder/said" &
  eventually grep -qs Waiting "$folder/said"
  touch "$folder/go"
  wait
  [[ $(tr '\n' ' ' <"$order") == "begin end begin end " ]] || fail "two builds ran in one folder at once"
}

a_quick_build_tells_only_what_is_wrong() {
  local told
  told=$(printf '%s\n' '[1/2] Building' 'warning: odd' '[2/2] Linking' 'ninja: no work to do.' | each_minute)
  [[ $told == "warning: odd" ]] || fail "a build says: $told"
}

at_least_one_job_and_no_more_than_processors() {
  local jobs
  jobs=$(parallel_jobs)
  ((jobs >= 1 && jobs <= $(nproc))) || fail "$jobs jobs on $(nproc) processors"
}

a_free_port_can_be_listened_at() {
  local port
  port=$(python3 "$root/tools/free_port.py")
  python3 -c "import socket; socket.create_server(('127.0.0.1', $port))" || fail "port $port is not free"
}

each_explains_itself_and_leaves_nothing_behind
is_found_through_a_link
what_is_no_option_is_refused
a_preset_that_is_none_is_refused_and_leaves_no_folder
shell_and_cmake_share_one_cache
a_quick_build_tells_only_what_is_wrong
at_least_one_job_and_no_more_than_processors
a_free_port_can_be_listened_at
sudo_does_not_make_the_build_roots
one_build_at_a_time
say "The tools do as they say."
