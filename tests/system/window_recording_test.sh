#!/usr/bin/env bash
# window_recording_test.sh BIN: tests recordings with the real programs on a virtual display, with a real mouse and
# real keys. Records everything; saves the last 30 s; opens the recording in a window of its own, where it is plotted,
# played and stepped; drops a recording onto a window. Keeps pictures of it in the folder pictures beside BIN.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
bin=$1
# shellcheck source-path=SCRIPTDIR source=../../tools/common.sh
source "$root/tools/common.sh"
# shellcheck source-path=SCRIPTDIR source=../../tools/processes.sh
source "$root/tools/processes.sh"
# shellcheck source-path=SCRIPTDIR source=../../tools/display.sh
source "$root/tools/display.sh"
readonly signal='robot/arm/state.Joints.position[0]'
readonly curve='facts["curves"]["robot/arm/state.Joints.position[0]"]'
readonly replay='facts["replay"]'
readonly joints=robot/arm/state/Joints

main() {
  begin_run
  use_own_folders
  echo "XDG_DOCUMENTS_DIR=\"$RUN_FOLDER\"" >"$XDG_CONFIG_HOME/user-dirs.dirs"
  start_display 1440 900
  start_system
  records_everything
  saves_the_last_seconds
  opens_the_recording
  plays_and_steps
  opens_a_dropped_recording
}

start_system() {
  local process
  address=127.0.0.1:$(free_port)
  start gcm-gui "$bin/gcm-gui" --no-tour --theme dark --listen "$address" --describe-ui "$RUN_FOLDER/ui.json"
  wait_until "the GCM in the window" "$bin/gcm" --gcm "$address" ls
  for process in robot desk; do
    start "$process" "$bin/lcm" --name "$process" --gcm "$address" --system "$root/resources/systems/demo.json"
  done
  wait_until "the components" ui wait 'facts["processes"]["desk"]["components"]["teleoperation"] == "active"' 1
  wait_until "the arm" ui wait 'facts["processes"]["robot"]["components"]["arm"] == "active"' 1
  "$bin/gcm" --gcm "$address" connect desk/teleoperation/Robot robot/arm/Control >"$RUN_FOLDER/connect"
  wait_until "the keyboard" has_keyboard gcm-gui
  plot_signal
  ui wait "$curve"'["rows"] > 1000'
  passed "the moving arm is plotted"
}

plot_signal() {
  open_row robot/arm robot/arm/state robot/arm/state.Joints robot/arm/state.Joints.position
  ui click rows "$signal"
  ui key p
}

records_everything() {
  ui click widgets recordMenu
  ui wait '"recordChoices" in widgets'
  ui key e
  ui click widgets record
  ui wait 'facts["recording"]["running"] and facts["recording"]["rows"] > 5000'
  keep_picture gcm-gui flow-recording-dark
  ui click widgets stopRecording
  ui wait '"showRecording" in widgets'
  recorded=$(ui show 'facts["recording"]["file"]')
  recorded=${recorded//\"/}
  must_hold "$recorded" "$joints" robot/arm/Control/MoveTo desk/teleoperation/state
  passed "two clicks recorded the rows of all components"
}

saves_the_last_seconds() {
  local pressed
  pressed=$(date +%s%N)
  ui key ctrl+shift+r
  ui wait 'facts["recording"]["file"] != "'"$recorded"'" and "showRecording" in widgets'
  saved=$(ui show 'facts["recording"]["file"]')
  saved=${saved//\"/}
  must_hold "$saved" "$joints" desk/teleoperation/state
  (($(figure "$saved" begin_ns) < pressed - 1000000000)) ||
    fail "$saved begins when the keys were pressed, although nothing had to be armed"
  passed "Ctrl+Shift+R saved rows from before the keys were pressed"
}

# must_hold FILE TOPIC...: fails unless the recording is complete and has topics that begin like these.
must_hold() {
  local file=$1 topic
  shift
  "$bin/gcm" info "$file" --check >"$RUN_FOLDER/info" || fail "$file is not complete" "$(<"$RUN_FOLDER/info")"
  "$bin/gcm" info "$file" >"$RUN_FOLDER/info"
  for topic in "$@"; do
    grep -qF "$topic" "$RUN_FOLDER/info" || fail "$file has no $topic:" "$(<"$RUN_FOLDER/info")"
  done
}

# figure FILE KEY: prints a number about a recording.
figure() {
  "$bin/gcm" --json info "$1" | python3 -c 'import json, sys; print(json.load(sys.stdin)[sys.argv[1]])' "$2"
}

opens_the_recording() {
  start replay "$bin/gcm-gui" "$recorded" --theme light --describe-ui "$RUN_FOLDER/replay.json"
  UI_FILE=$RUN_FOLDER/replay.json
  wait_until "the recording" ui wait "$replay"'["open"]' 1
  shows_replay "$recorded"
  ui wait 'facts["processes"]["robot"]["components"]["arm"] == "active"'
  ui wait '"record" not in widgets'
  passed "the recording has a window of its own with a stripe that says REPLAY, and nothing to record with"
}

# shows_replay FILE: waits for the stripe across the window, the slider and the button that plays.
shows_replay() {
  ui wait "$replay"'["file"] == "'"$1"'" and '"$replay"'["stripe"].startswith("REPLAY '"$(basename "$1")"' ")'
  ui wait 'widgets["replayStripe"][2] == window[2] and {"replayTime", "replayPlay", "replayStep"} <= widgets.keys()'
}

plays_and_steps() {
  local moment former
  ui click widgets replayStripe
  wait_until "the keyboard" has_keyboard replay
  plot_signal
  ui click widgets replayTime
  ui wait "abs($replay"'["seconds"] / '"$replay"'["length"] - 0.5) < 0.02 and '"$curve"'["rows"] > 1000'
  passed "a click into the middle of the slider shows the middle of the recording, with its past in the plot"

  ui key bracketleft bracketleft
  ui wait "$replay"'["speed"] == 0.25'
  moment=$(settled_moment)
  ui click widgets replayPlay
  ui wait "$replay"'["playing"] and '"$replay"'["seconds"] > '"$moment + 0.2"
  keep_picture replay flow-replay-light
  ui key space
  ui wait "not $replay"'["playing"]'
  passed "a click plays it slowly, and the space bar pauses it"

  moment=$(settled_moment)
  ui click widgets replayStep
  ui wait "$moment < $replay"'["seconds"] < '"$moment + 1"
  former=$(settled_moment)
  ui key period
  ui wait "$former < $replay"'["seconds"] < '"$former + 1"
  ui key comma
  ui wait "$replay"'["seconds"] == '"$former"
  passed "it is stepped row by row, by click and keys, forward and back"
  kill_hard replay
}

# settled_moment: prints the shown moment, in s since the start, as soon as it stays the same.
settled_moment() {
  local before now=
  until [[ -n $now && $now == "$before" ]]; do
    before=$now
    sleep 0.5
    now=$(ui show "$replay"'["seconds"]')
  done
  say "$now"
}

# The window starts another program, which is found by its title.
opens_a_dropped_recording() {
  local process words
  unset UI_FILE
  start files "$bin/../tests/drag_source" "$saved"
  wait_until "the file to drag" has_window files
  ui drag screen "$(middle_of files)" widgets graph
  wait_until "the window of the dropped recording" is_dropped_shown
  process=$(xdotool getwindowpid "$(dropped_window)")
  mapfile -d '' words <"/proc/$process/cmdline"
  kill "$process"

  start again "${words[@]}" --describe-ui "$RUN_FOLDER/again.json"
  UI_FILE=$RUN_FOLDER/again.json
  wait_until "the recording" ui wait "$replay"'["open"]' 1
  shows_replay "$saved"
  keep_picture again flow-dropped-dark
  passed "a file that is dropped on the graph is opened by the program that the window starts"
}

dropped_window() { xdotool search --onlyvisible --name "^REPLAY $(basename "$saved")" | tail -n 1; }
is_dropped_shown() { [[ -n $(dropped_window) ]]; }

# middle_of NAME: prints the middle of the window of that process, such as 120,80.
middle_of() {
  local X Y WIDTH HEIGHT
  eval "$(xdotool getwindowgeometry --shell "$(window_of "$1")")"
  say "$((X + WIDTH / 2)),$((Y + HEIGHT / 2))"
}

# keep_picture NAME PICTURE: keeps a picture of the window of that process.
keep_picture() {
  mkdir -p "$bin/../pictures"
  screenshot "$(window_of "$1")" "$bin/../pictures/$2.png"
}

main "$@"
