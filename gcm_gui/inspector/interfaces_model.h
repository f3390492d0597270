#pragma once

#include <gcm_gui/inspector/health_figures.h>
#include <gcm_gui/models/row_list_model.h>
#include <gcm_gui/theme/state_mark.h>
#include <tendon/gcm/catalog.h>

#include <QHash>
#include <QString>

namespace tendon::gui {

/// One row of the inspector's list of interfaces.
struct InterfaceRow {
  enum class Kind { kRequired, kProvided, kMember, kEvent, kColumn, kPeer };

  Kind kind = Kind::kMember;
  QString path;
  QString name;
  QString types;
  QString value;
  StateMark mark = StateMark::kNotConnected;  ///< of interfaces and peers
  InterfaceName required;                     ///< of a peer: the required end of the connection
  QString expiry = {};                        ///< of a command that ends by itself: when it does

  bool operator==(const InterfaceRow&) const = default;
};

/// The interfaces of one component, one below the other: each with what it is connected to, then
/// its commands with their types, and its events.
class InterfacesModel : public RowListModel<InterfaceRow> {
  Q_OBJECT

 public:
  using RowListModel::RowListModel;

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  /// Shows a component; nothing when there is none of these names.
  void show(const Catalog& catalogue, const std::string& process, const std::string& component);
  /// That stands for this path itself; -1 where none does.
  [[nodiscard]] int rowOf(const QString& path) const;
  /// How the connections of its interfaces do, by path of the interface.
  void showHealth(const QHash<QString, InterfaceHealth>& health);

 private:
  QHash<QString, InterfaceHealth> health_;
};

}  // namespace tendon::gui
