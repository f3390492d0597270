# Sourced by tools/demo and the test of the window: starts, waits for and stops the processes of a run.
# Needs common.sh.
# shellcheck shell=bash

declare -A process_ids=()
process_order=()

# Makes RUN_FOLDER for the logs and files of the processes. Call this function before start. When the script ends, for
# whatever reason, the processes are stopped and the folder is removed.
begin_run() {
  RUN_FOLDER=$(mktemp -d)
  trap stop_all EXIT
  trap 'exit 130' INT
  trap 'exit 143' TERM HUP
}

# Uses separate folders for settings, state and runtime files, so that every run starts like the first one.
use_own_folders() {
  mkdir -m 700 "$RUN_FOLDER"/{config,state,runtime}
  export XDG_CONFIG_HOME=$RUN_FOLDER/config XDG_STATE_HOME=$RUN_FOLDER/state XDG_RUNTIME_DIR=$RUN_FOLDER/runtime
}

free_port() { python3 "$TENDON_ROOT/tools/free_port.py"; }

# start NAME COMMAND...: starts a command in the background, with its output in NAME.log.
start() {
  local name=$1
  shift
  "$@" >"$RUN_FOLDER/$name.log" 2>&1 &
  process_ids[$name]=$!
  process_order=("$name" "${process_order[@]}")
}

is_running() { kill -0 "${process_ids[$1]}" 2>/dev/null; }

# wait_until WHAT COMMAND...: waits until the command succeeds. Fails after a minute, or as soon as a process has
# ended.
wait_until() {
  local what=$1 deadline=$((SECONDS + 60)) name
  shift
  until "$@" >/dev/null 2>&1; do
    for name in "${process_order[@]}"; do
      is_running "$name" || fail_with_log "$name" "$name ended while waiting for $what; the end of its log:"
    done
    name=${process_order[0]}
    ((SECONDS < deadline)) || fail_with_log "$name" "No sign of $what after a minute; the end of the log of $name:"
    sleep 0.1
  done
}

fail_with_log() {
  say "$2" >&2
  tail -n 15 "$RUN_FOLDER/$1.log" >&2
  exit 1
}

passed() { say "  passed: $*"; }

# kill_hard NAME: kills the process at once and forgets it.
kill_hard() {
  local name kept=()
  kill -KILL "${process_ids[$1]}"
  wait "${process_ids[$1]}" 2>/dev/null || true
  for name in "${process_order[@]}"; do [[ $name == "$1" ]] || kept+=("$name"); done
  process_order=("${kept[@]}")
}

# Asks all processes to end, the last one started first; kills each one that has not ended after 5 s.
stop_all() {
  local name id
  for name in "${process_order[@]}"; do
    id=${process_ids[$name]}
    kill "$id" 2>/dev/null || continue
    timeout 5 tail -s 0.05 --pid="$id" -f /dev/null || kill -KILL "$id" 2>/dev/null || true
    wait "$id" 2>/dev/null || true
  done
  process_order=()
  rm -rf "$RUN_FOLDER"
}
