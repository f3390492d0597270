#!/usr/bin/env bash
# changes_test.sh: tests in a small repository that tools/format and tools/tidy check the changed files. The exit code
# is 77, which skips the test, if a program that they need is missing.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck source-path=SCRIPTDIR source=../../tools/common.sh
source "$root/tools/common.sh"
for program in git clang-tidy; do
  command -v "$program" >/dev/null || { echo "skipped: $program is not installed" && exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null

in_repository() { git -C "$folder" -c user.name=Test -c user.email=test@example.org "$@"; }

make_repository() {
  cp -r "$root/tools" "$root/.clang-format" "$folder"
  mkdir "$folder/core"
  printf 'int   kept;\n' >"$folder/core/kept.cpp"
  printf 'int gone;\n' >"$folder/core/gone.cpp"
  in_repository init --quiet --initial-branch=main
  in_repository add .
  in_repository commit --quiet --message Begin
  in_repository switch --quiet --create work
}

format() { "$folder/tools/format" "$@" >"$folder/said" 2>&1; }

what_has_changed_is_formatted_and_nothing_else() {
  format --check || {
    [[ $? != 77 ]] || { cat "$folder/said" && exit 77; }
    fail "nothing has changed:" "$(<"$folder/said")"
  }
  printf 'int   committed;\n' >"$folder/core/committed.cpp"
  rm "$folder/core/gone.cpp"
  in_repository add --all
  in_repository commit --quiet --message Change
  printf 'int   unknown;\n' >"$folder/core/un known.h"

  ! format --check || fail "tools/format --check passes what is not formatted"
  [[ $(head -2 "$folder/said") == $'core/committed.cpp\ncore/un known.h' ]] || fail "it names:" "$(<"$folder/said")"
  [[ $(<"$folder/core/committed.cpp") == "int   committed;" ]] || fail "tools/format --check changes a file"
  format || fail "tools/format fails:" "$(<"$folder/said")"
  format --check || fail "tools/format leaves something to format:" "$(<"$folder/said")"
  [[ $(<"$folder/core/un known.h") == "int unknown;" ]] || fail "what git does not know is not formatted"
  [[ $(<"$folder/core/kept.cpp") == "int   kept;" ]] || fail "tools/format formats what is as on main"
  ! format --check --all || fail "tools/format --all passes what is not formatted"
}

a_git_that_fails_is_told() {
  mkdir "$folder/programs"
  cat >"$folder/programs/git" <<END
#!/bin/sh
case " \$* " in *" diff "*) echo "git is broken" >&2; exit 128 ;; esac
exec "$(command -v git)" "\$@"
END
  chmod +x "$folder/programs/git"
  local tool
  for tool in "format --check" tidy; do
    # shellcheck disable=SC2086  # words
    ! PATH=$folder/programs:$PATH "$folder"/tools/$tool >"$folder/said" 2>&1 ||
      fail "tools/$tool passes though git fails"
    grep -qx "git is broken" "$folder/said" || fail "tools/$tool says:" "$(<"$folder/said")"
  done
  rm -r "$folder/programs"
}

other_files_are_refused_at_once() {
  ! "$folder/tools/tidy" "$folder/core/one.cpp" "$folder/tools/tidy" >"$folder/said" 2>&1 ||
    fail "tools/tidy reads itself"
  [[ $(<"$folder/said") == "Only .h and .cpp files are read by clang-tidy, not: tools/tidy" ]] ||
    fail "tools/tidy says:" "$(<"$folder/said")"
}

# Replaces cmake by a script, which writes the compile commands and checks that the preset is locked.
dev_is_configured_where_it_does_not_know_a_file() {
  printf 'int* added = nullptr;\n' >"$folder/core/added.cpp"
  mkdir "$folder/programs"
  cat >"$folder/programs/cmake" <<END
#!/bin/sh
flock --nonblock "$folder/build/dev" true || touch "$folder/was_locked"
cat >"$folder/build/dev/compile_commands.json" <<COMMANDS
[{"directory": "$folder/build/dev", "file": "$folder/core/added.cpp",
  "command": "c++ -std=c++20 -o x.o -c $folder/core/added.cpp"}]
COMMANDS
END
  chmod +x "$folder/programs/cmake"
  PATH=$folder/programs:$PATH "$folder/tools/tidy" "$folder/core/added.cpp" >"$folder/said" 2>&1 ||
    fail "tools/tidy does not configure what it needs:" "$(<"$folder/said")"
  grep -qx "Configuring dev." "$folder/said" || fail "tools/tidy says:" "$(<"$folder/said")"
  [[ -e $folder/was_locked ]] || fail "tools/tidy configures while others may build"
  PATH=$folder/programs:$PATH "$folder/tools/tidy" "$folder/core/added.cpp" >"$folder/said" 2>&1
  ! grep -q "Configuring" "$folder/said" || fail "tools/tidy configures again, though it knows the file"
  rm -r "$folder/programs"
}

# Two sources are compiled together, with the command of a third source that includes them.
joined_sources_are_read_alone() {
  local build=$folder/build/dev
  mkdir -p "$build/Unity"
  printf 'Checks: "-*,modernize-use-nullptr"\nWarningsAsErrors: "*"\n' >"$folder/.clang-tidy"
  printf 'static_assert(NUMBER == 7);\nint* one = 0;\n' >"$folder/core/one.cpp"
  printf 'int* two = 0;\n' >"$folder/core/two.cpp"
  printf '#include "%s"\n' "$folder/core/one.cpp" "$folder/core/two.cpp" >"$build/Unity/unity_0_cxx.cxx"
  cat >"$build/compile_commands.json" <<END
[{"directory": "$build", "file": "$build/Unity/unity_0_cxx.cxx",
  "command": "c++ -std=c++20 -DNUMBER=7 -Wno-subobject-linkage -o x.o -c $build/Unity/unity_0_cxx.cxx"}]
END

  ! "$folder/tools/tidy" "$folder/core/one.cpp" >"$folder/said" 2>&1 || fail "tools/tidy finds nothing"
  grep -q "one.cpp:2:.*modernize-use-nullptr" "$folder/said" || fail "tools/tidy says:" "$(<"$folder/said")"
  ! grep -q "two.cpp" "$folder/said" || fail "tools/tidy reads what is not named:" "$(<"$folder/said")"
  printf 'int* one = nullptr;\n' >"$folder/core/one.cpp"
  "$folder/tools/tidy" "$folder/core/one.cpp" >"$folder/said" 2>&1 || fail "tools/tidy finds:" "$(<"$folder/said")"
}

make_repository
what_has_changed_is_formatted_and_nothing_else
joined_sources_are_read_alone
a_git_that_fails_is_told
other_files_are_refused_at_once
dev_is_configured_where_it_does_not_know_a_file
say "What has changed is formatted and read."
