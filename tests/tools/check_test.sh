#!/usr/bin/env bash
# check_test.sh: tests tools/check in a small project. tools/check must print only failures and the reasons of skipped
# tests, and notice a changed preset.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
# shellcheck source-path=SCRIPTDIR source=../../tools/common.sh
source "$root/tools/common.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# make_preset VARIABLES: writes the preset dev with these cache variables of CMake.
make_preset() {
  cat >"$folder/CMakePresets.json" <<END
{"version": 6,
 "configurePresets": [{"name": "dev", "generator": "Ninja", "binaryDir": "build/dev", "cacheVariables": $1}],
 "buildPresets": [{"name": "dev", "configurePreset": "dev"}],
 "testPresets": [{"name": "dev", "configurePreset": "dev", "output": {"outputOnFailure": true}}]}
END
}

# Copies the tools, except for tools/setup: the small project needs no packages.
make_project() {
  cp -r "$root/tools" "$folder"
  printf '#!/bin/sh\n' >"$folder/tools/setup"
  make_preset '{}'
  cat >"$folder/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(small NONE)
enable_testing()
add_custom_target(step ALL COMMAND sleep 0.1)
add_test(NAME silent COMMAND echo "this passes")
add_test(NAME scripted COMMAND sh -c "echo 'Skipped: no such tool.'; exit 77")
set_tests_properties(scripted PROPERTIES SKIP_RETURN_CODE 77)
add_test(NAME Suite.Case COMMAND printf
  "[ RUN ] Suite.Case\\n/a/b.cpp:12: Skipped\\nno zsh\\nhere\\n\\n[  SKIPPED ] Suite.Case\\n")
set_tests_properties(Suite.Case PROPERTIES
  SKIP_REGULAR_EXPRESSION "[[]  SKIPPED []]")
add_test(NAME joined.1 COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/joined.xml tests/results/joined.1.xml)
if(EXISTS ${PROJECT_SOURCE_DIR}/broken)
  add_test(NAME broken COMMAND sh -c "echo 'Test project x'; echo '100% tests passed, 0'; echo 'the reason'; exit 1")
endif()
END
  cat >"$folder/joined.xml" <<'END'
<testsuites><testsuite name="Joined">
<testcase name="Runs" status="run" result="completed" time="7.5" classname="Joined" />
<testcase name="IsOff" status="notrun" result="suppressed" time="0" classname="Joined" />
<testcase name="NeedsATool" status="run" result="skipped" time="0" classname="Joined">
<skipped message="/a/b.cpp:13&#x0A;no such&#x0A;tool here&#x0A;"></skipped>
</testcase></testsuite></testsuites>
END
}

says() { grep -qxF -- "$1" "$folder/said" || fail "tools/check does not say '$1', but:" "$(<"$folder/said")"; }
is_silent_about() { ! grep -qF -- "$1" "$folder/said" || fail "tools/check says '$1':" "$(<"$folder/said")"; }

skipped_tests_are_told_with_their_reasons() {
  "$folder/tools/check" >"$folder/said" || fail "tools/check fails where all passed:" "$(<"$folder/said")"
  says "Skipped scripted: no such tool."
  says "Skipped Suite.Case: no zsh here"
  says "Skipped Joined.NeedsATool: no such tool here"
  says "Tests: 2 ran, 3 were skipped."
  says "100% tests passed, 0 tests failed out of 4"
  is_silent_about "this passes"
  is_silent_about "silent"
  is_silent_about "did not run"
}

failures_are_told_whole() {
  touch "$folder/broken"
  ! "$folder/tools/check" >"$folder/said" 2>&1 || fail "tools/check passes though a test fails"
  says "Test project x"
  says "100% tests passed, 0"
  says "the reason"
  grep -q "broken (Failed)" "$folder/said" || fail "the summary does not name what failed:" "$(<"$folder/said")"
  says "Preset dev failed; see the messages above. To repeat: tools/check --preset dev"
}

times_are_those_of_the_last_run() {
  printf '# ninja log v5\n0\t2500\t1\tcore/CMakeFiles/core.dir/a.cpp.o\tabc\n' >"$folder/build/dev/.ninja_log"
  "$folder/tools/check" --times >"$folder/said"
  says "     2.5 s  core: a.cpp.o"
  says "     7.5 s  Joined.Runs"
  grep -q "s  silent$" "$folder/said" || fail "the time of a test is not told:" "$(<"$folder/said")"
  "$folder/tools/check" --times --preset none >"$folder/said"
  says "build/none has no tests.xml, so the times of its tests are unknown; run tools/check."
}

a_change_of_the_compiler_forgets_nothing_of_the_preset() {
  local compiler
  sed -i 's/small NONE/small CXX/' "$folder/CMakeLists.txt"
  for compiler in g++ clang++; do
    make_preset '{"CMAKE_CXX_COMPILER": "'$compiler'", "TOLD": "yes"}'
    "$folder/tools/check" >"$folder/said" 2>&1 || fail "tools/check fails with $compiler:" "$(<"$folder/said")"
  done
  grep -q "^CMAKE_CXX_COMPILER:.*clang++$" "$folder/build/dev/CMakeCache.txt" || fail "the compiler is still g++"
  grep -q "^TOLD:.*=yes$" "$folder/build/dev/CMakeCache.txt" || fail "a variable of the preset is lost"
}

# The test of dev waits until preset no-ice was built at the same time. The next preset would take a minute to build.
ahead_builds_beside_the_tests_and_ends_with_them() {
  rm "$folder/broken"
  python3 - "$folder/CMakePresets.json" <<'END'
import json, sys
presets = json.load(open(sys.argv[1]))
for name in ("no-ice", "no-gui"):
    presets["configurePresets"].append({"name": name, "inherits": "dev", "binaryDir": "build/" + name})
    presets["buildPresets"].append({"name": name, "configurePreset": name})
json.dump(presets, open(sys.argv[1], "w"))
END
  cat >>"$folder/CMakeLists.txt" <<'END'
if(CMAKE_BINARY_DIR MATCHES "no-ice")
  add_custom_target(built ALL COMMAND touch built)
elseif(CMAKE_BINARY_DIR MATCHES "no-gui")
  add_custom_target(built ALL COMMAND touch started && sleep 4321)
elseif(EXISTS ${PROJECT_SOURCE_DIR}/waits)
  add_test(NAME waits COMMAND
    sh -c "until [ -e ../no-ice/built ] && [ -e ../no-gui/started ]; do sleep 0.1; done")
  set_tests_properties(waits PROPERTIES TIMEOUT 250)
endif()
END
  touch "$folder/waits"
  "$folder/tools/check" --ahead >"$folder/said" 2>&1 || fail "tools/check --ahead fails:" "$(<"$folder/said")"
  says "100% tests passed, 0 tests failed out of 5"
  is_silent_about "no-ice"
  timeout 20 sh -c 'while pgrep -f "^sleep 4321"; do sleep 0.1; done' >/dev/null ||
    fail "tools/check has ended, but not what it built ahead"
  rm "$folder/waits"
}

make_project
skipped_tests_are_told_with_their_reasons
failures_are_told_whole
times_are_those_of_the_last_run
ahead_builds_beside_the_tests_and_ends_with_them
a_change_of_the_compiler_forgets_nothing_of_the_preset
say "tools/check says what matters."
