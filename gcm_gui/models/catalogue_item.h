#pragma once

#include <gcm_gui/models/connection_index.h>
#include <gcm_gui/models/state_of.h>
#include <tendon/gcm/catalog.h>
#include <tendon/payload/plot_channel.h>

#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace tendon::gui {

enum class ItemKind {
  kProcess,
  kComponent,
  kProvided,
  kRequired,
  kCommand,
  kEvent,
  kFunction,
  kHandler,
  kColumn,   ///< of a state table
  kGroup,    ///< a structure or an array inside a column
  kChannel,  ///< one number inside a column
};

/// One row of the catalogue, and the rows below it. Its path is its identity: unique, and the same
/// after a restart.
struct CatalogueItem {
  ItemKind kind = ItemKind::kProcess;
  QString name;
  QString path;
  QString folded;  ///< the path in lower case, for filters
  QString detail;  ///< payload types, or what a required interface is connected to
  QString value;   ///< what the second column shows; of numbers the model knows it
  QString unit;
  /// Of an interface what is at the other end, of a component whose; empty: nothing. Of others
  /// none.
  std::optional<QString> connected;
  std::optional<StateMark> mark;
  QString state;                         ///< the word for filters: "active", "lost", "connected"
  bool gone = false;                     ///< its process is lost or has left
  Standstill still = Standstill::kNone;  ///< of a component: why its values are old
  QString host;                          ///< of a process, in lower case
  std::int64_t since = 0;  ///< of a process: when it came into its state, ns since 1970
  Fingerprint type;        ///< of a column
  int channel = -1;        ///< of a number: which of its column's channels

  CatalogueItem* parent = nullptr;
  int row = 0;
  std::vector<std::unique_ptr<CatalogueItem>> children;

  /// Appends it as the last child.
  CatalogueItem& Add(std::unique_ptr<CatalogueItem> child);
  /// This one and all below it.
  [[nodiscard]] int Count() const;
};

/// The word for `type:` in filters and for screen readers: "process", "command", "column".
[[nodiscard]] QString KindWord(ItemKind kind);

/// The rows of one process, as the catalogue describes it. Columns have no children yet: the shape
/// of a value is known once one has arrived.
[[nodiscard]] std::unique_ptr<CatalogueItem> BuildProcess(const ConnectionIndex& connections,
                                                          const ProcessEntry& entry);
[[nodiscard]] std::unique_ptr<CatalogueItem> BuildComponent(const ConnectionIndex& connections,
                                                            const ProcessEntry& entry,
                                                            const ComponentDescription& component);

/// The rows below a column whose value has these channels: groups by field and index. A column that
/// is one number has none.
[[nodiscard]] std::vector<std::unique_ptr<CatalogueItem>> BuildChannels(
    const CatalogueItem& column, const std::vector<PlotChannel>& channels);

}  // namespace tendon::gui
