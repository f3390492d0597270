#!/usr/bin/env bash
# desktop_test.sh CMAKE BUILD PROGRAM: checks that the desktop files that the part `gui` installs exist and are valid.
set -euo pipefail
cmake=$1 build=$2 program=$3
[[ -x $program ]]
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

"$cmake" --install "$build" --component gui --prefix "$prefix" >/dev/null

share=$prefix/share
entry=$share/applications/org.tendon.GcmGui.desktop
icon=$share/icons/hicolor/scalable/apps/org.tendon.GcmGui.svg
metadata=$share/metainfo/org.tendon.GcmGui.metainfo.xml
types=$share/mime/packages/org.tendon.GcmGui.xml
desktop-file-validate "$entry"
appstreamcli validate --no-net "$metadata"
xmllint --noout "$icon" "$metadata" "$types"

# The files must name the same program, icon and MIME types.
all=
for type in $(xmllint --xpath '//*[local-name()="mime-type"]/@type' "$types" | sed 's/ *type="\([^"]*\)"/\1 /g'); do
  all+="$type;"
  grep -q "<mediatype>$type</mediatype>" "$metadata"
done
[[ $all == *x-mcap* ]]
grep -qx "MimeType=$all" "$entry"
grep -qx "Icon=$(basename "$icon" .svg)" "$entry"
grep -q "^Exec=$(basename "$program") " "$entry"
[[ -x $prefix/bin/$(basename "$program") ]]
