# Sourced by the scripts beside it: paths, short messages, root, building.
# shellcheck shell=bash

TENDON_ROOT=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
# The same as in cmake/tendon_cache.cmake.
TENDON_CACHE=${XDG_CACHE_HOME:-${HOME:-/tmp}/.cache}/tendon
# shellcheck disable=SC2034  # read by the scripts that source this file
QWT_CACHE=$TENDON_CACHE/qwt-6.3.0

# say SENTENCE...: each on a line of its own.
say() { printf '%s\n' "$@"; }

# fail SENTENCE [DETAIL...]: one clear sentence, then what helps, each on a line of its own.
fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

# help_if_asked WORD...: --help prints the comment at the head of the script and ends it.
help_if_asked() {
  [[ " $* " == *" --help "* || " $* " == *" -h "* ]] || return 0
  sed -n '2,/^[^#]/ s/^# \?//p' "$0"
  exit 0
}

# without_sudo WORD...: a script that was called through sudo starts anew as whoever called it. Else the build and the
# cache would be root's. The scripts ask for sudo by themselves where they need it.
without_sudo() {
  ((EUID == 0)) && [[ ${SUDO_USER:-root} != root ]] || return 0
  exec sudo -H -u "$SUDO_USER" -- "$0" "$@"
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

# How many compilers this machine can feed: one a processor, and 1.5 GB of free memory for each.
parallel_jobs() {
  local processors memory
  processors=$(nproc)
  memory=$(awk '$1 == "MemAvailable:" { print int($2 / 1500000) }' /proc/meminfo)
  ((memory < processors)) || memory=$processors
  say "$((memory > 1 ? memory : 1))"
}

# must_be_preset NAME: before a folder is made for it.
must_be_preset() {
  local names
  names=$(cmake -S "$TENDON_ROOT" --list-presets | sed -nE 's/^ +"([^"]+)".*/\1/p')
  grep -qxF -- "$1" <<<"$names" || fail "There is no preset '$1'; there are: ${names//$'\n'/, }."
}

# each_minute: of ninja's lines "[37/923] ...", one a minute; whatever else it says, as it is.
# Behind a pipe, whose exit code is that of its first failure with pipefail, as all scripts here set it.
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

# locked PRESET COMMAND...: runs it while nobody else configures or builds the preset in this tree. Makes its folder.
locked() {
  mkdir -p "$TENDON_ROOT/build/$1"
  {
    flock --nonblock 9 || { say "Waiting for another build of $1." && flock 9; }
    "${@:2}"  # sees no local variables of this function
  } 9<"$TENDON_ROOT/build/$1"
}

# build_preset PRESET [TARGET...]: configures and builds it. Says no more than how far it is, unless something is wrong
# or a person watches. One at a time in one tree.
build_preset() {
  must_be_preset "$1"
  cd "$TENDON_ROOT" || return
  locked "$1" configure_and_build "$@"
}

configure_and_build() {
  local preset=$1 targets=()
  shift
  (($# == 0)) || targets=(--target "$@")
  # Presets, and clones in other places, share what the compiler makes of the same source.
  export CCACHE_BASEDIR=$TENDON_ROOT CCACHE_NOHASHDIR=1
  export CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(parallel_jobs)}

  say "Building $preset."
  configure "$preset"
  local compile=(in_place "$preset" cmake --build --preset "$preset" "${targets[@]}")
  if [[ -t 1 ]]; then "${compile[@]}"; else "${compile[@]}" | each_minute; fi ||
    fail "Preset $preset does not build; what is above says why."
}

# configure PRESET: in its folder, which exists. Says nothing, unless something is wrong. If the folder was made with
# another compiler, CMake forgets all that the preset says, and goes on: then it starts afresh.
configure() {
  local log="$TENDON_ROOT/build/$1/configure.log"
  : >"$log"
  if ! logged "$log" in_place "$1" cmake --preset "$1" ||
    { grep -q "require your cache to be deleted" "$log" &&
      ! logged "$log" in_place "$1" cmake --fresh --preset "$1"; }; then
    fail "Preset $1 cannot be configured; all of CMake's output is in build/$1/configure.log."
  fi
}

# changed_files PATTERN...: of the files that match, those that differ from where this branch left main, committed or
# not, and those that git does not know yet. Paths from the root, each with a zero byte behind it.
changed_files() {
  # Git writes nothing, not even what it has found out about the files, for another git may run at the same time.
  local git=(env GIT_OPTIONAL_LOCKS=0 git -C "$TENDON_ROOT") base
  base=$(branch_point) &&
    "${git[@]}" diff -z --name-only --relative --diff-filter=d "$base" -- "$@" &&
    "${git[@]}" ls-files -z --others --exclude-standard -- "$@"
}

# The commit at which this branch left main. On main, and where no main is known: the last commit that was pushed, or
# the last one.
branch_point() {
  local git=(git -C "$TENDON_ROOT") bases=(main origin/main HEAD) base
  [[ $("${git[@]}" branch --show-current) != main ]] || bases=(origin/main HEAD)
  for base in "${bases[@]}"; do
    "${git[@]}" merge-base HEAD "$base" 2>/dev/null && return
  done
  return 1
}

# is_clone: true where git can say what has changed.
is_clone() { git -C "$TENDON_ROOT" rev-parse --verify --quiet HEAD >/dev/null 2>&1; }
