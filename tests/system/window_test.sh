#!/usr/bin/env bash
# window_test.sh BIN: tests the real programs on a virtual display, with a real mouse. Connects by clicks and moves the
# arm; plots ten seconds of 1 kHz rows without loss; disconnects; kills an LCM and starts it again; ends a recording
# window by a signal.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
bin=$1
# shellcheck source-path=SCRIPTDIR source=../../tools/common.sh
source "$root/tools/common.sh"
# shellcheck source-path=SCRIPTDIR source=../../tools/processes.sh
source "$root/tools/processes.sh"
# shellcheck source-path=SCRIPTDIR source=../../tools/display.sh
source "$root/tools/display.sh"
readonly robot_wire='facts["connections"]["desk/teleoperation/Robot"]'
readonly curve='facts["curves"]["robot/arm/state.Joints.position[0]"]'

main() {
  begin_run
  use_own_folders
  echo "XDG_DOCUMENTS_DIR=\"$RUN_FOLDER\"" >"$XDG_CONFIG_HOME/user-dirs.dirs"
  start_display 1440 900
  address=127.0.0.1:$(free_port)
  start gcm-gui "$bin/gcm-gui" --listen "$address" --describe-ui "$RUN_FOLDER/ui.json"
  wait_until "the GCM in the window" "$bin/gcm" --gcm "$address" ls
  shows_around
  start_lcm robot
  start_lcm desk
  wait_until "the catalogue" ui wait 'facts["processes"].keys() == {"gcm", "robot", "desk"}' 1
  wait_until "the components" ui wait 'facts["processes"]["desk"]["components"]["teleoperation"] == "active"' 1
  passed "the catalogue is complete"

  connects_by_click
  plots_without_loss
  disconnects_and_undoes
  heals_after_a_kill
  passed "the longest event handler took $(ui show 'facts["longestHandlerMs"]') ms of processor time"
  survives_its_gcm
  records_until_a_signal
}

shows_around() {
  wait_until "the tour" ui wait '"tour.card" in widgets' 1
  wait_until "the keyboard" has_keyboard gcm-gui
  ui key Right Escape
  ui wait '"tour.card" not in widgets'
  passed "the first window shows around, until Escape"
}

start_lcm() {
  start "$1" "$bin/lcm" --name "$1" --gcm "$address" --system "$root/resources/systems/demo.json"
}

connects_by_click() {
  ui click ports desk/teleoperation/Robot
  ui wait 'ports["robot/arm/Control"]["role"] == "candidate"'
  ui wait 'ports["desk/old_arm/Control"]["role"] == "unfit"'
  ui wait '{"robot/arm/Control", "desk/old_arm/Control"} <= candidates.keys()'
  ui click ports robot/arm/Control
  ui wait "$robot_wire"'["state"] == "active"'
  passed "two clicks connected teleoperation to the arm"
}

plots_without_loss() {
  local before
  open_row robot/arm robot/arm/state robot/arm/state.Joints robot/arm/state.Joints.position
  ui click rows 'robot/arm/state.Joints.position[0]'
  ui key p
  ui wait "$curve"'["rows"] > 0'
  local unreported="$curve"'["tick"] - '"$curve"'["rows"] - '"$curve"'["lost"]'
  before=$(ui show "$unreported")
  ui wait "abs($curve"'["value"]) > 0.3'
  passed "the arm moves"
  wait_until "ten seconds of rows" ui wait "$curve"'["rows"] >= 10000' 1
  ui wait "$curve"'["repeated"] == 0 and '"$unreported <= $before"
  # With a sanitizer, the window may be so late that its link is renewed. Even then every loss must be reported.
  if grep -q __asan_init "$bin/gcm-gui"; then
    passed "10000 rows, of which none is repeated, and each lost row is reported"
    return
  fi
  ui wait "$curve"'["lost"] == 0'
  passed "10000 rows at 1 kHz, none lost or repeated by their ticks"
}

disconnects_and_undoes() {
  ui click ports desk/teleoperation/Robot
  ui key Escape d
  ui wait '"desk/teleoperation/Robot" not in facts["connections"]'
  passed "D disconnects"
  ui key ctrl+z
  ui wait "$robot_wire"'["state"] == "active"'
  passed "Ctrl+Z connects again"
}

heals_after_a_kill() {
  local rows
  kill_hard robot
  ui wait 'facts["processes"]["robot"]["state"] == "lost"'
  ui wait "$curve"'["stale"]'
  ui wait "$robot_wire"'["state"] == "pending"'
  ui click rows desk
  ui wait 'facts["selection"] == ["desk"]'
  passed "a killed process is shown lost, and the window answers"
  rows=$(ui show "$curve"'["rows"]')
  start_lcm robot
  ui wait 'facts["processes"]["robot"]["state"] == "alive"'
  ui wait "$robot_wire"'["state"] == "active"'
  ui wait "not $curve"'["stale"] and '"${curve}[\"rows\"] > $rows + 500"
  passed "started again, it is connected and plotted again"
}

# A second window joins the GCM that the first window hosts, and survives the end of the first window.
survives_its_gcm() {
  viewer() { python3 "$TENDON_ROOT/tools/ui.py" "$RUN_FOLDER/viewer.json" "$@"; }
  echo '{"version": 1, "plots": [{"window": 30, "curves": [{"path": "robot/arm/state.Joints.position[1]",' \
    '"unit": "rad"}]}]}' >"$RUN_FOLDER/mine.plots.json"
  start viewer "$bin/gcm-gui" --gcm "$address" --layout "$RUN_FOLDER/mine.plots.json" \
    --describe-ui "$RUN_FOLDER/viewer.json"
  wait_until "the second window" viewer wait "$robot_wire"'["state"] == "active"' 1
  viewer wait '"tour.card" not in widgets'
  viewer wait 'facts["curves"]["robot/arm/state.Joints.position[1]"]["rows"] > 100'
  passed "the second window shows nobody around, and begins with its layout"
  kill_hard gcm-gui
  viewer wait 'not facts["gcmConnected"] and "lostBanner" in widgets'
  viewer wait 'facts["processes"].keys() == {"gcm", "robot", "desk"}'
  passed "a window whose GCM is killed says so, and keeps what it knew"
  start gcm "$bin/gcm" --gcm "$address" serve
  viewer wait 'facts["gcmConnected"] and "lostBanner" not in widgets'
  viewer wait 'facts["processes"]["robot"]["state"] == "alive" and '"$robot_wire"'["state"] == "active"'
  passed "with a new GCM it heals"
}

# A signal ends the window while it records.
records_until_a_signal() {
  local file
  viewer click widgets record
  viewer wait 'facts["recording"]["running"] and facts["recording"]["rows"] > 500'
  file=$(viewer show 'facts["recording"]["file"]')
  file=${file//\"/}
  kill -TERM "${process_ids[viewer]}"
  wait "${process_ids[viewer]}" && fail "the window ended as if no signal had come"
  "$bin/gcm" info "$file" --check >"$RUN_FOLDER/info" || fail "$file is not complete"
  grep -q robot/arm/state/Joints "$RUN_FOLDER/info" || fail "$file lacks what is plotted"
  passed "a window that is ended by a signal completes its recording"
}

main "$@"
