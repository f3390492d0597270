#pragma once

#include <gcm_gui/theme/state_mark.h>
#include <tendon/gcm/catalog.h>

#include <QAbstractListModel>
#include <QString>
#include <vector>

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

  bool operator==(const InterfaceRow&) const = default;
};

/// The interfaces of one component, one below the other: each with what it is connected to, then
/// its commands with their types, and its events.
class InterfacesModel : public QAbstractListModel {
  Q_OBJECT

 public:
  using QAbstractListModel::QAbstractListModel;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] const InterfaceRow& row(int row) const;

  /// Shows a component; nothing when there is none of these names.
  void show(const Catalog& catalogue, const std::string& process, const std::string& component);

 private:
  std::vector<InterfaceRow> rows_;
};

}  // namespace tendon::gui
