#!/usr/bin/env bash
# search_test.sh: tests search.sh with programs that behave like the fuzzer.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/corpus"
echo seed >"$work/corpus/seed"
export found=$work/found/recording

# Makes the program `fuzzer` of the lines on the standard input. Its last argument is the folder of the inputs.
make_fuzzer() {
  { echo '#!/usr/bin/env bash' && cat; } >"$work/fuzzer"
  chmod +x "$work/fuzzer"
}

# Runs a search. Sets `status` and `said`.
search() {
  status=0
  said=$("$here/search.sh" "$work/fuzzer" recording "$work/corpus" 1 "$found" 2>&1) || status=$?
}

fail() {
  printf '%s\n--- status %s, output:\n%s\n' "$1" "$status" "$said"
  exit 1
}

says() { [[ $said == *"$1"* ]] || fail "this is missing: $1"; }

a_search_without_a_finding_passes_and_leaves_the_corpus_as_it_was() {
  make_fuzzer <<'END'
[[ -e ${*: -1}/seed ]] || exit 3
touch "${*: -1}/new"
echo "options: $*"
END
  search
  [[ $status == 0 ]] || fail "the search must pass"
  says "options: --target=recording -max_total_time=1"
  [[ $(ls "$work/corpus") == seed && -z $(ls "$found") ]] || fail "the folders must be as they were"
}

# libFuzzer ends with 77, which CTest would take for a skipped test.
a_finding_fails_the_test_and_is_kept() {
  make_fuzzer <<'END'
echo slow >"$found/slow-unit-1"
echo "artifact_prefix='$found/'; Test unit written to $found/slow-unit-1" >&2
echo bad >"$found/crash-1"
echo "artifact_prefix='$found/'; Test unit written to $found/crash-1" >&2
exit 77
END
  search
  [[ $status == 1 ]] || fail "the search must fail with 1"
  says "an input breaks 'recording'; it is kept as $found/crash-1"
  says "repeat it with: $work/fuzzer --target=recording $found/crash-1"
  [[ -e $found/crash-1 ]] || fail "the input must be kept"
}

a_later_search_begins_with_what_was_found() {
  make_fuzzer <<'END'
[[ -e ${*: -1}/crash-1 ]]
END
  search
  [[ $status == 0 ]] || fail "the input that was found must be among the first inputs"
}

a_failure_without_an_input_is_told() {
  make_fuzzer <<'END'
exit 2
END
  search
  [[ $status == 1 ]] || fail "the search must fail"
  says "the fuzzer failed without an input"
}

a_search_without_a_finding_passes_and_leaves_the_corpus_as_it_was
a_finding_fails_the_test_and_is_kept
a_later_search_begins_with_what_was_found
a_failure_without_an_input_is_told
