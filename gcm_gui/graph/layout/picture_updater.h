#pragma once

#include <gcm_gui/graph/layout/graph_picture.h>
#include <gcm_gui/session/catalogue_store.h>

#include <map>
#include <set>
#include <vector>

namespace tendon::gui {

class ConnectionIndex;

/// Keeps the picture of a catalogue, and rebuilds only the parts that a change has touched.
/// Rebuilding the whole picture of a thousand components would block the window too long.
class PictureUpdater {
 public:
  /// Returns the same picture as PictureOf(). `touched` must name all parts that have changed since
  /// the last call.
  const GraphPicture& update(const Catalogue& catalogue, const ChangedParts& touched);

  [[nodiscard]] const GraphPicture& picture() const { return picture_; }

 private:
  struct Interfaces {
    SharedList<RequiredDescription> required;
    SharedList<ProvidedDescription> provided;

    bool operator==(const Interfaces&) const = default;
  };

  void updatePart(const Catalogue& catalogue, const ConnectionIndex& connections,
                  const ChangedPart& part);
  /// Stores the interfaces of a part. Returns true if they have changed.
  bool takeInterfaces(const Catalogue& catalogue, const ChangedPart& part);
  /// Stores the connections. Returns true if connections were added or removed; changed states do
  /// not count.
  bool takeEdges(const Catalogue& catalogue);

  GraphPicture picture_;
  std::set<Affinity> fitting_;  // possible connections
  std::map<ChangedPart, Interfaces> interfaces_;
};

[[nodiscard]] GraphPicture PictureOf(const Catalogue& catalogue);

}  // namespace tendon::gui
