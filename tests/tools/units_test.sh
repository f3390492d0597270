#!/usr/bin/env bash
# units_test.sh FOLDER: checks that systemd accepts each unit in the folder without a remark.
set -euo pipefail
folder=$1
if ! command -v systemd-analyze >/dev/null; then
  echo "skipped: systemd-analyze is not installed, so the units were not verified"
  exit 77
fi
# If systemd has remarks even on a trivial unit, the test is skipped.
trivial=$(mktemp -d)
trap 'rm -rf "$trivial"' EXIT
printf '[Service]\nType=oneshot\nExecStart=/usr/bin/env true\n' >"$trivial/trivial.service"
if ! remarks=$(systemd-analyze verify --man=no "$trivial/trivial.service" 2>&1) || [[ -n $remarks ]]; then
  echo "skipped: systemd-analyze cannot verify a unit here: $remarks"
  exit 77
fi
for unit in "$folder"/*.service; do
  if ! remarks=$(systemd-analyze verify --man=no "$unit" 2>&1) || [[ -n $remarks ]]; then
    echo "$unit: $remarks"
    exit 1
  fi
  grep -q '^ExecStart=/usr/bin/env ' "$unit" || { echo "$unit: name its program by /usr/bin/env"; exit 1; }
done
