#include <gcm_gui/graph/places/saved_places.h>
#include <gcm_gui/models/text.h>

namespace tendon::gui {

std::map<std::string, SystemFile::Position> LayoutOf(const GraphPlaces& places) {
  std::map<std::string, SystemFile::Position> layout;
  for (const auto& [path, place] : places.all()) {
    layout.emplace(path.toStdString(), SystemFile::Position{place.x(), place.y()});
  }
  return layout;
}

GraphPlaces::Map PlacesOf(const SystemFile& file) {
  GraphPlaces::Map places;
  for (const auto& [path, position] : file.layout) {
    const QPointF place(position.x, position.y);
    if (IsPlace(place)) places.emplace(ToQString(path), place);
  }
  return places;
}

}  // namespace tendon::gui
