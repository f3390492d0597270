#pragma once

#include <gcm_gui/models/connections_model.h>

#include <QSortFilterProxyModel>
#include <QString>

namespace tendon::gui {

/// The connections of one component, seen from it: its own interface, and what is at the other end.
class ComponentConnections : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit ComponentConnections(ConnectionsModel& connections, QObject* parent = nullptr);

  void setComponent(const std::string& process, const std::string& component);

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  [[nodiscard]] bool filterAcceptsColumn(int column, const QModelIndex&) const override {
    return column == 0;
  }

 private:
  [[nodiscard]] bool isOwn(const InterfaceName& name) const;

  ConnectionsModel& connections_;
  InterfaceName component_;
};

}  // namespace tendon::gui
