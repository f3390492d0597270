# Sourced by the scripts beside it: paths, short messages, root.
# shellcheck shell=bash

TENDON_ROOT=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
TENDON_CACHE=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/tendon
# shellcheck disable=SC2034  # read by the scripts that source this file
QWT_CACHE=$TENDON_CACHE/qwt-6.3.0

say() { printf '%s\n' "$*"; }

# fail SENTENCE [DETAIL...]: one clear sentence, then what helps, each on a line of its own.
fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

# can_be_root: true for root, and where sudo can ask for a password or needs none.
can_be_root() {
  ((EUID == 0)) && return
  command -v sudo >/dev/null || return
  sudo -n true 2>/dev/null || [[ -t 0 ]]
}

as_root() {
  if ((EUID == 0)); then "$@"; else sudo "$@"; fi
}

# logged LOGFILE COMMAND...: runs it in silence; after a failure shows the end of its output.
logged() {
  local log=$1
  shift
  "$@" >>"$log" 2>&1 && return
  tail -n 15 "$log" >&2
  return 1
}

# in_place PRESET COMMAND...: runs it as the programs of the preset need it. ThreadSanitizer of older compilers
# cannot live with all the address randomisation of newer kernels.
in_place() {
  local preset=$1
  shift
  if [[ $preset == tsan ]] && setarch --addr-no-randomize true 2>/dev/null; then
    setarch --addr-no-randomize "$@"
  else
    "$@"
  fi
}

# build_preset PRESET [TARGET...]: configures and builds it, in silence unless something is wrong or a person watches.
build_preset() {
  local preset=$1 log="$TENDON_ROOT/build/$1/configure.log" targets=() quiet=()
  shift
  (($# == 0)) || targets=(--target "$@")
  [[ -t 1 ]] || quiet=(-- --quiet)
  # Presets, and clones in other places, share what the compiler makes of the same source.
  export CCACHE_BASEDIR=$TENDON_ROOT CCACHE_NOHASHDIR=1

  cd "$TENDON_ROOT" || return
  mkdir -p "build/$preset"
  : >"$log"
  say "Building $preset."
  logged "$log" in_place "$preset" cmake --preset "$preset" ||
    fail "Preset $preset cannot be configured; all of CMake's output is in build/$preset/configure.log."
  in_place "$preset" cmake --build --preset "$preset" "${targets[@]}" "${quiet[@]}" ||
    fail "Preset $preset does not build; the compiler says why above."
}
