#pragma once

#include <gcm_gui/models/row_list_model.h>
#include <tendon/manager/component_description.h>

#include <QString>

namespace tendon::gui {

/// One parameter of a component; its name is the path in the configuration, such as
/// "gains.joint[0]".
struct ConfigurationRow {
  QString name;
  QString value;

  bool operator==(const ConfigurationRow&) const = default;
};

/// The data from which a component was created: class, library, and its parameters one by one.
class ConfigurationModel : public RowListModel<ConfigurationRow> {
  Q_OBJECT

 public:
  using RowListModel::RowListModel;

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  void show(const ComponentDescription& component);
};

}  // namespace tendon::gui
