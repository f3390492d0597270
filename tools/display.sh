# Sourced by tools/demo and the test of the window: a virtual display with a window manager, real mouse clicks and
# screenshots. Needs processes.sh.
# shellcheck shell=bash disable=SC2154

# True if there is a display on which a window can be shown.
has_display() {
  [[ -n ${WAYLAND_DISPLAY:-} ]] || { [[ -n ${DISPLAY:-} ]] && xdpyinfo >/dev/null 2>&1; }
}

# start_display WIDTH HEIGHT: starts a virtual display. The X server chooses the first free number and reports it.
start_display() {
  local answer=$RUN_FOLDER/display
  # shellcheck disable=SC2016  # expanded by sh
  start display sh -c 'exec Xvfb -displayfd 3 -screen 0 "$2x$3x24" -nolisten tcp 3>"$1"' - "$answer" "$1" "$2"
  wait_until "the virtual display" test -s "$answer"
  DISPLAY=:$(<"$answer")
  export DISPLAY
  unset WAYLAND_DISPLAY
  start window-manager openbox --sm-disable
  wait_until "the window manager" window_manager_is_up
}

window_manager_is_up() { [[ $(xprop -root _NET_SUPPORTING_WM_CHECK) == *"window id"* ]]; }

# window_of NAME: prints the identifier of the visible window of that process.
window_of() { xdotool search --onlyvisible --pid "${process_ids[$1]}" | tail -n 1; }
has_window() { [[ -n $(window_of "$1") ]]; }
# has_keyboard NAME: true if a window of that process has the keyboard focus.
has_keyboard() { [[ $(xdotool getactivewindow getwindowpid) == "${process_ids[$1]}" ]]; }

# ui VERB...: drives the window that describes itself in UI_FILE, or else in ui.json; see ui.py.
ui() { python3 "$TENDON_ROOT/tools/ui.py" "${UI_FILE:-$RUN_FOLDER/ui.json}" "$@"; }

# open_row PATH...: expands rows of the catalogue, one after the other.
open_row() {
  local path
  for path in "$@"; do
    ui click rows "$path"
    ui key Right
  done
}

# screenshot WINDOW FILE: saves a picture. The file is replaced as a whole, even if two runs write it at the same
# time.
screenshot() {
  import -window "$1" "$RUN_FOLDER/screenshot.png"
  mv -f "$RUN_FOLDER/screenshot.png" "$2"
}
