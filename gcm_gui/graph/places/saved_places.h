#pragma once

#include <gcm_gui/graph/places/graph_places.h>
#include <tendon/gcm/system_file.h>

#include <map>
#include <string>

namespace tendon::gui {

/// Places as a system file has them, and back.
[[nodiscard]] std::map<std::string, SystemFile::Position> LayoutOf(const GraphPlaces& places);
[[nodiscard]] GraphPlaces::Map PlacesOf(const SystemFile& file);

}  // namespace tendon::gui
