#pragma once

#include <gcm_gui/inspector/health_figures.h>
#include <gcm_gui/models/row_list_model.h>
#include <gcm_gui/theme/state_mark.h>
#include <tendon/gcm/catalogue.h>

#include <QHash>
#include <QString>
#include <string>

namespace tendon::gui {

/// One row in the inspector's list of interfaces.
struct InterfaceRow {
  enum class Kind { kRequired, kProvided, kMember, kEvent, kColumn, kPeer };

  Kind kind = Kind::kMember;
  QString path;
  QString name;
  QString types;
  QString value;
  StateMark mark = StateMark::kNotConnected;  ///< for interfaces and peers
  InterfaceName required;  ///< for a peer: the required interface of the connection
  QString expiry = {};     ///< of a command: its time limit

  bool operator==(const InterfaceRow&) const = default;
};

/// The interfaces of one component. Below each interface come its peers, then its commands with
/// their types, then its events.
class InterfacesModel : public RowListModel<InterfaceRow> {
  Q_OBJECT

 public:
  using RowListModel::RowListModel;

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  /// Shows a component, or nothing if it does not exist.
  void show(const Catalogue& catalogue, const std::string& process, const std::string& component);
  /// Returns the row with exactly this path; -1 if there is none.
  [[nodiscard]] int rowOf(const QString& path) const;
  /// Sets the health of the interfaces' connections, by path of the interface.
  void showHealth(const QHash<QString, InterfaceHealth>& health);

 private:
  QHash<QString, InterfaceHealth> health_;
};

}  // namespace tendon::gui
