#!/usr/bin/env bash
# search.sh PROGRAM TARGET CORPUS SECONDS FOUND: lets the fuzzer PROGRAM search for inputs that break TARGET. It begins
# with copies of the inputs in the folders CORPUS and FOUND, and adds new inputs only to these copies. Keeps an input
# that breaks TARGET in FOUND, so that each later search fails, too, until the fault is repaired.
set -euo pipefail
program=$1 target=$2 corpus=$3 seconds=$4 found=$5

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$found" "$scratch/inputs"
cp -rT "$corpus" "$scratch/inputs"
cp -rT "$found" "$scratch/inputs"
longest=100 # seconds for one input, on a busy machine
"$program" "--target=$target" "-max_total_time=$seconds" "-timeout=$longest" "-report_slow_units=$longest" \
  "-artifact_prefix=$found/" -print_final_stats=1 -verbosity=0 "$scratch/inputs" 2>&1 | tee "$scratch/log" && exit

kept=$(sed -n 's/^.*Test unit written to //p' "$scratch/log" | grep -v /slow-unit- | tail -n 1) || true
echo
if [[ -z $kept ]]; then
  echo "the fuzzer failed without an input; the lines above have the reason"
  exit 1
fi
echo "an input breaks '$target'; it is kept as $kept"
echo "repeat it with: $program --target=$target $kept"
echo "after the repair, move it to $corpus, and let its name say what is wrong in it"
exit 1
