#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>
#include <gcm_gui/session/catalogue_store.h>

#include <map>
#include <set>
#include <vector>

namespace tendon::gui {

class ConnectionIndex;

/// Keeps the picture of a catalogue, and makes anew what a change has touched: the picture of a
/// thousand components takes longer than the window may stand still.
class PictureUpdater {
 public:
  /// The picture as PictureOf() would make it. `touched` are all parts that differ from the last
  /// time.
  const GraphPicture& update(const Catalog& catalogue, const Touched& touched);

  [[nodiscard]] const GraphPicture& picture() const { return picture_; }

 private:
  struct Interfaces {
    SharedList<RequiredDescription> required;
    SharedList<ProvidedDescription> provided;

    bool operator==(const Interfaces&) const = default;
  };

  void updatePart(const Catalog& catalogue, const ConnectionIndex& connections,
                  const TouchedPart& part);
  /// Whether the interfaces of a part are others than before, and remembers them.
  bool takeInterfaces(const Catalog& catalogue, const TouchedPart& part);
  /// Whether what is connected has changed, whatever its state.
  bool takeEdges(const Catalog& catalogue);

  GraphPicture picture_;
  std::set<Affinity> fitting_;  // what could be connected
  std::map<TouchedPart, Interfaces> interfaces_;
};

[[nodiscard]] GraphPicture PictureOf(const Catalog& catalogue);

}  // namespace tendon::gui
