#pragma once

#include <gcm_gui/session/catalogue_store.h>

#include <QAbstractTableModel>
#include <QString>
#include <vector>

namespace tendon::gui {

/// All connections, one per row. The path of a row is the path of its required interface; the rows
/// are sorted by it.
class ConnectionsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kRequired, kProvided, kState, kColumnCount };

  using QAbstractTableModel::QAbstractTableModel;

  [[nodiscard]] int rowCount(const QModelIndex& parent) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                    int role) const override;

  [[nodiscard]] const ConnectionDescription& connection(int row) const;
  /// The row of this required interface; -1 if there is none.
  [[nodiscard]] int rowOf(const QString& required) const;

 public Q_SLOTS:
  /// Pass true while the link to the GCM is lost: everything is then shown in its last known state.
  void setOutdated(bool outdated);
  void update(const tendon::Catalogue& catalogue);

 private:
  std::vector<ConnectionDescription> rows_;
  bool outdated_ = false;
};

}  // namespace tendon::gui
