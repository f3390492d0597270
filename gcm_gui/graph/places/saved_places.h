#pragma once

#include <gcm_gui/graph/places/graph_places.h>
#include <tendon/gcm/system_file.h>

#include <map>
#include <string>

namespace tendon::gui {

/// Converts between positions of the graph and those of a system file.
[[nodiscard]] std::map<std::string, SystemFile::Position> LayoutOf(const GraphPlaces& places);
[[nodiscard]] GraphPlaces::Map PlacesOf(const SystemFile& file);

}  // namespace tendon::gui
