#include <gcm_gui/call/value_form.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <tendon/payload/json/strict_json.h>

#include <QGridLayout>
#include <QLabel>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

using Json = nlohmann::ordered_json;

enum Column { kName, kEntry, kUnit, kColumns };

QString HelpOf(const Schema::Field& field) {
  QStringList lines;
  if (!field.help.empty()) lines << ToQString(field.help);
  if (field.range) {
    lines << QStringLiteral("%1 to %2 %3")
                 .arg(NumberText(field.range->lowest), NumberText(field.range->highest),
                      ToQString(field.unit));
  }
  lines << ToQString(field.schema.TypeName());
  return lines.join('\n');
}

}  // namespace

class ValueForm::Structure final : public Entry {
 public:
  void add(std::string name, std::unique_ptr<Entry> entry) {
    fields_.emplace_back(std::move(name), std::move(entry));
  }

  [[nodiscard]] Json value() const override {
    Json object = Json::object();
    for (const auto& [name, entry] : fields_) object[name] = entry->value();
    return object;
  }
  void setValue(const Json& value) override {
    if (!value.is_object()) return;
    for (const auto& [name, entry] : fields_) {
      if (const auto found = value.find(name); found != value.end()) entry->setValue(*found);
    }
  }

 private:
  std::vector<std::pair<std::string, std::unique_ptr<Entry>>> fields_;
};

ValueForm::ValueForm(const Schema& schema, QWidget* parent)
    : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(kInset, kGrid, kInset, kGrid);
  grid_->setHorizontalSpacing(2 * kGrid);
  grid_->setVerticalSpacing(kGrid);
  grid_->setColumnStretch(kEntry, 1);
  const bool has_fields = schema.kind() == Schema::Kind::kStructure;
  entry_ = has_fields ? addFields(schema, {}, 0)
                      : addField({.name = "value", .unit = {}, .schema = schema}, {}, 0);
}

ValueForm::~ValueForm() = default;

std::string ValueForm::json() const { return entry_->value().dump(); }

void ValueForm::setJson(const std::string& json) {
  if (const auto value = ParseOrderedJson(json)) entry_->setValue(*value);
}

std::unique_ptr<Entry> ValueForm::addFields(const Schema& structure, const QString& path,
                                            int level) {
  auto entry = std::make_unique<Structure>();
  for (const auto& field : structure.fields()) {
    entry->add(field.name, addField(field, path, level));
  }
  return entry;
}

std::unique_ptr<Entry> ValueForm::addField(const Schema::Field& field, const QString& path,
                                           int level) {
  const QString name = ToQString(field.name);
  const QString whole = path.isEmpty() ? name : path + '.' + name;
  addName(field, name, level);
  const int row = grid_->rowCount() - 1;
  if (field.schema.kind() == Schema::Kind::kStructure) {
    return addFields(field.schema, whole, level + 1);
  }
  auto [entry, widget] = MakeEntry(field, whole, [this] { Q_EMIT edited(); });
  widget->setObjectName(QStringLiteral("form.") + whole);
  if (widget->toolTip().isEmpty()) widget->setToolTip(HelpOf(field));
  const bool is_wide = field.schema.kind() == Schema::Kind::kArray;
  is_wide ? grid_->addWidget(widget, row + 1, kName, 1, kColumns)
          : grid_->addWidget(widget, row, kEntry);
  return std::move(entry);
}

void ValueForm::addName(const Schema::Field& field, const QString& text, int level) {
  const int row = grid_->rowCount();
  auto* name = new QLabel(text);
  name->setContentsMargins(level * kIndent, 0, 0, 0);
  name->setMinimumHeight(kRowHeight);
  name->setToolTip(HelpOf(field));
  SetRole(*name, QStringLiteral("dim"));
  grid_->addWidget(name, row, kName);
  if (field.unit.empty()) return;
  auto* unit = new QLabel(ToQString(field.unit));
  SetRole(*unit, QStringLiteral("dim mono"));
  grid_->addWidget(unit, row, kUnit);
}

}  // namespace tendon::gui
