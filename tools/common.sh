# Sourced by the scripts in this folder: paths, messages, commands as root, and building.
# shellcheck shell=bash

TENDON_ROOT=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
# The same folder as in cmake/tendon_cache.cmake.
TENDON_CACHE=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/tendon
# shellcheck disable=SC2034  # read by the scripts that source this file
QWT_CACHE=$TENDON_CACHE/qwt-6.3.0
# shellcheck disable=SC2034  # the same as in tests/core/recording/CMakeLists.txt
ORACLE_CACHE=$TENDON_CACHE/recording-oracle

# say SENTENCE...: prints each sentence on a separate line.
say() { printf '%s\n' "$@"; }

# fail SENTENCE [DETAIL...]: prints the error in one sentence, then each detail on a separate line, and exits.
fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

# help_if_asked WORD...: if a word is --help or -h, prints the comment at the head of the script and exits.
help_if_asked() {
  [[ " $* " == *" --help "* || " $* " == *" -h "* ]] || return 0
  sed -n '2,/^[^#]/ s/^# \?//p' "$0"
  exit 0
}

# without_sudo WORD...: if the script was called through sudo, starts it again as the user who called sudo. Otherwise
# the build and the cache would belong to root. The scripts call sudo themselves when they need it.
without_sudo() {
  ((EUID == 0)) && [[ ${SUDO_USER:-root} != root ]] || return 0
  exec sudo -H -u "$SUDO_USER" -- "$0" "$@"
}

# can_be_root: true for root, or if sudo needs no password or can ask for it.
can_be_root() {
  ((EUID == 0)) && return
  command -v sudo >/dev/null || return
  sudo -n true 2>/dev/null || [[ -t 0 ]]
}

as_root() {
  if ((EUID == 0)); then "$@"; else sudo "$@"; fi
}

# logged LOGFILE COMMAND...: runs a command with its output in the log; after a failure prints the end of the log.
logged() {
  local log=$1
  shift
  "$@" >>"$log" 2>&1 && return
  tail -n 15 "$log" >&2
  return 1
}

# in_place PRESET COMMAND...: runs a command in the environment that programs of the preset need. ThreadSanitizer of
# older compilers does not work with the address randomisation of newer kernels.
in_place() {
  local preset=$1
  shift
  if [[ $preset == tsan ]] && setarch --addr-no-randomize true 2>/dev/null; then
    setarch --addr-no-randomize "$@"
  else
    "$@"
  fi
}

# The number of compilers that can run at a time: one per processor, each with 1.5 GB of free memory.
parallel_jobs() {
  local processors memory
  processors=$(nproc)
  memory=$(awk '$1 == "MemAvailable:" { print int($2 / 1500000) }' /proc/meminfo)
  ((memory < processors)) || memory=$processors
  say "$((memory > 1 ? memory : 1))"
}

# must_be_preset NAME: fails if there is no such preset. Call it before a folder is made for the preset.
must_be_preset() {
  local names
  names=$(cmake -S "$TENDON_ROOT" --list-presets | sed -nE 's/^ +"([^"]+)".*/\1/p')
  grep -qxF -- "$1" <<<"$names" || fail "There is no preset '$1'; there are: ${names//$'\n'/, }."
}

# each_minute: passes one of ninja's lines "[37/923] ..." a minute, and all other lines unchanged. Use it behind a
# pipe; all scripts here set pipefail, so a failure of ninja is not lost.
each_minute() {
  local line next=$((SECONDS + 60))
  while IFS= read -r line; do
    if [[ ! $line =~ ^\[([0-9]+)/([0-9]+)\]\  ]]; then
      [[ $line == "ninja: no work to do." ]] || say "$line"
    elif ((SECONDS >= next)); then
      say "  ${BASH_REMATCH[1]} of ${BASH_REMATCH[2]}"
      next=$((SECONDS + 60))
    fi
  done
}

# locked PRESET COMMAND...: makes the folder of the preset and locks it while the command runs, so that nobody else
# configures or builds the preset in this tree.
locked() {
  mkdir -p "$TENDON_ROOT/build/$1"
  {
    flock --nonblock 9 || { say "Waiting for another build of $1." && flock 9; }
    "${@:2}"  # sees no local variables of this function
  } 9<"$TENDON_ROOT/build/$1"
}

# build_preset PRESET [TARGET...]: configures and builds a preset. Without a terminal, prints only the progress and
# errors. One build of a preset at a time in one tree.
build_preset() {
  must_be_preset "$1"
  cd "$TENDON_ROOT" || return
  locked "$1" configure_and_build "$@"
}

configure_and_build() {
  local preset=$1 targets=()
  shift
  (($# == 0)) || targets=(--target "$@")
  # Presets, and clones in other folders, share the compiled objects of equal sources.
  export CCACHE_BASEDIR=$TENDON_ROOT CCACHE_NOHASHDIR=1
  export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(parallel_jobs)}

  say "Building $preset."
  configure "$preset"
  local compile=(in_place "$preset" cmake --build --preset "$preset" "${targets[@]}")
  if [[ -t 1 ]]; then "${compile[@]}"; else "${compile[@]}" | each_minute; fi ||
    fail "Preset $preset does not build; see the messages above."
}

# configure PRESET: configures a preset in its existing folder. Prints only errors. If the folder was made with
# another compiler, CMake loses the settings of the preset and continues; then configures again from nothing.
configure() {
  local log="$TENDON_ROOT/build/$1/configure.log"
  : >"$log"
  if ! logged "$log" in_place "$1" cmake --preset "$1" ||
    { grep -q "require your cache to be deleted" "$log" &&
      ! logged "$log" in_place "$1" cmake --fresh --preset "$1"; }; then
    fail "Preset $1 cannot be configured; all of CMake's output is in build/$1/configure.log."
  fi
}

# changed_files PATTERN...: prints the matching files that were changed on this branch since it left main, committed
# or not, and those that are not tracked yet. Paths are relative to the root; each ends with a zero byte.
changed_files() {
  # Git must not write its index, because another git command may run at the same time.
  local git=(env GIT_OPTIONAL_LOCKS=0 git -C "$TENDON_ROOT") base
  base=$(branch_point) &&
    "${git[@]}" diff -z --name-only --relative --diff-filter=d "$base" -- "$@" &&
    "${git[@]}" ls-files -z --others --exclude-standard -- "$@"
}

# The commit at which this branch left main. On main, or without a main: the last pushed commit; if nothing was pushed,
# the last commit.
branch_point() {
  local git=(git -C "$TENDON_ROOT") bases=(main origin/main HEAD) base
  [[ $("${git[@]}" branch --show-current) != main ]] || bases=(origin/main HEAD)
  for base in "${bases[@]}"; do
    "${git[@]}" merge-base HEAD "$base" 2>/dev/null && return
  done
  return 1
}

# is_clone: true if git can list the changed files.
is_clone() { git -C "$TENDON_ROOT" rev-parse --verify --quiet HEAD >/dev/null 2>&1; }
