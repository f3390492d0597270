#pragma once

#include <gcm_gui/models/row_list_model.h>
#include <tendon/manager/component_description.h>

#include <QString>

namespace tendon::gui {

/// One parameter of a component, by its path in the configuration: "gains.joint[0]".
struct ConfigurationRow {
  QString name;
  QString value;

  bool operator==(const ConfigurationRow&) const = default;
};

/// The creation data of a component: class, library, and its parameters one by one.
class ConfigurationModel : public RowListModel<ConfigurationRow> {
  Q_OBJECT

 public:
  using RowListModel::RowListModel;

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

  void show(const ComponentDescription& component);
};

}  // namespace tendon::gui
