#!/usr/bin/env bash
# format_test.sh ROOT: every header and source file is as clang-format leaves it. Exit code 77, which skips the test,
# where that program is missing or formats differently.
set -euo pipefail
readonly kVersion=14

main() {
  local root=$1 program
  program=$(command -v "clang-format-$kVersion" || command -v clang-format) ||
    skip "clang-format is not installed; tools/setup installs it"
  [[ $("$program" --version) == *" version $kVersion."* ]] ||
    skip "only clang-format $kVersion decides, and this is: $("$program" --version)"
  cd "$root"
  find . -name build -prune -o -path './.*' -prune -o \( -name '*.h' -o -name '*.cpp' \) -print0 |
    xargs -0 "$program" --dry-run -Werror || fail "To mend them: clang-format -i FILE..."
}

skip() {
  printf 'Skipped: %s.\n' "$1"
  exit 77
}

fail() {
  printf '%s\n' "$1" >&2
  exit 1
}

main "$@"
