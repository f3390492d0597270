#pragma once

#include <gcm_gui/models/connection_index.h>
#include <gcm_gui/models/state_marks.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/payload/numeric_field.h>

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
  kColumn,  ///< of a state table
  kGroup,   ///< a structure or an array in a column
  kField,   ///< one number in a column
};

/// One row of the catalogue with its child rows. The path identifies the row: it is unique, and the
/// same after a restart.
struct CatalogueItem {
  ItemKind kind = ItemKind::kProcess;
  QString name;
  QString path;
  QString folded;  ///< the path in lower case, for filters
  QString detail;  ///< payload types, or the peer of a required interface
  QString value;   ///< the text in the second column; the model itself has the values of numbers
  QString unit;
  /// The peers of an interface, or of all interfaces of a component; an empty text if there are
  /// none. No value for other kinds of rows.
  std::optional<QString> connected;
  std::optional<StateMark> mark;
  QString state;      ///< the state as a word for filters: "active", "lost", "connected"
  bool gone = false;  ///< its process is lost or has left
  StaleReason still = StaleReason::kNone;  ///< of a component: why its values are old
  QString host;                            ///< of a process, in lower case
  std::int64_t since = 0;  ///< of a process: when it entered its state, ns since 1970
  Fingerprint type;        ///< of a column
  int field = -1;          ///< of a number: the field index in its column

  CatalogueItem* parent = nullptr;
  int row = 0;
  std::vector<std::unique_ptr<CatalogueItem>> children;

  /// Appends `child` as the last child.
  CatalogueItem& Add(std::unique_ptr<CatalogueItem> child);
  /// Returns the number of rows from this one downwards, including this one.
  [[nodiscard]] int Count() const;
};

/// Returns the word for the kind, used by `type:` in filters and by screen readers: "process",
/// "command", "column".
[[nodiscard]] QString KindWord(ItemKind kind);

/// Builds the rows of one process. Columns have no children yet, because the structure of a value
/// is known only when a value has arrived.
[[nodiscard]] std::unique_ptr<CatalogueItem> BuildProcess(const ConnectionIndex& connections,
                                                          const ProcessEntry& entry);
[[nodiscard]] std::unique_ptr<CatalogueItem> BuildComponent(const ConnectionIndex& connections,
                                                            const ProcessEntry& entry,
                                                            const ComponentDescription& component);

/// Builds the rows below a column with these fields, grouped by field and index. A column that is a
/// single number has no rows below it.
[[nodiscard]] std::vector<std::unique_ptr<CatalogueItem>> BuildFieldItems(
    const CatalogueItem& column, const std::vector<NumericField>& fields);

}  // namespace tendon::gui
