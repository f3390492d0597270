#include <gcm_gui/inspector/configuration_model.h>

#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <tendon/payload/json/strict_json.h>

#include <nlohmann/json.hpp>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::size_t kMaxRows = 500;

/// Adds the rows of a value: one row for a list of values; for an object, one row per member.
void AddRows(const QString& name, const nlohmann::ordered_json& value,
             std::vector<ConfigurationRow>& rows) {
  const bool is_list_of_objects = value.is_array() && !value.empty() && value.front().is_object();
  if (rows.size() == kMaxRows) return;
  if (value.is_object() && !value.empty()) {
    for (const auto& [key, field] : value.items()) {
      AddRows(name.isEmpty() ? ToQString(key) : name + '.' + ToQString(key), field, rows);
    }
  } else if (is_list_of_objects) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      AddRows(name + QStringLiteral("[%1]").arg(i), value[i], rows);
    }
  } else {
    const bool is_text = value.is_string();
    rows.push_back({name, ToQString(is_text ? value.get<std::string>() : value.dump())});
  }
}

}  // namespace

QVariant ConfigurationModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const ConfigurationRow& row = this->row(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return row.name;
    case kFontStyleRole:
      return static_cast<int>(FontStyle::kMono);
    case kTrailRole:
      return row.value;
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return QString(row.name + QStringLiteral(": ") + row.value);
    default:
      return {};
  }
}

void ConfigurationModel::show(const ComponentDescription& component) {
  std::vector<ConfigurationRow> fresh;
  fresh.push_back({QStringLiteral("class"), ToQString(component.class_name)});
  if (!component.library.empty()) {
    fresh.push_back({QStringLiteral("library"), ToQString(component.library)});
  }
  if (!component.configuration.empty()) {
    const auto json = ParseOrderedJson(component.configuration);
    if (json) {
      AddRows({}, *json, fresh);
    } else {
      fresh.push_back({QStringLiteral("configuration"), ToQString(component.configuration)});
    }
  }
  showRows(std::move(fresh));
}

}  // namespace tendon::gui
