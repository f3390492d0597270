#!/usr/bin/env bash
# format_test.sh ROOT: every header and source file is as clang-format leaves it. Exit code 77, which skips the test,
# where that program is missing or formats differently.
exec "$1/tools/format" --all --check
