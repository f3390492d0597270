#!/usr/bin/env bash
# format_test.sh ROOT: checks that clang-format would change no header and no source file. The exit code is 77, which
# skips the test, if clang-format is missing or has another version.
exec "$1/tools/format" --all --check
